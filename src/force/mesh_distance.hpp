#pragma once
#include <array>
#include <vector>

#include <unsupported/Eigen/BVH>

#include "sundrape/mesh/triangle_mesh.hpp"

namespace sundrape {

/// The triangle of a mesh that is nearest to a point.
struct NearestTriangle {
  double distance;    // [m]
  int triangle = -1;  // its number; −1: none as near as asked for
};

/// Distances to the nearest of many triangles, exact, by a tree of their boxes.
class MeshDistance {
 public:
  explicit MeshDistance(const TriangleMesh& mesh);

  /// The triangle nearest to x, or `at_most` [m] and none if all are farther than that.
  /// @param guess      a triangle that is likely to be near, or −1: the search is faster, its result the same
  /// @param tolerance  by how much the distance may be too long [m]. At the centre of a ball all triangles are equally
  ///                   near; a little freedom spares looking at each of them.
  [[nodiscard]] NearestTriangle nearest(const Vector3& x, double at_most, int guess, double tolerance) const;

 private:
  std::vector<std::array<Vector3, 3>> corners_;  // of each triangle
  Eigen::KdBVH<double, 3, int> tree_;            // of their numbers
};

/// Square of the distance from a point to a triangle [m²], which may have no area.
[[nodiscard]] double squared_distance_to_triangle(const Vector3& x, const std::array<Vector3, 3>& corners);

}  // namespace sundrape

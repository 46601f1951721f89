#pragma once
#include <memory>

#include "sundrape/force/obstacle.hpp"
#include "sundrape/mesh/triangle_mesh.hpp"

namespace sundrape {

class CubicSplineGrid;

/// A body given by a closed surface of triangles.
///
/// Its distance is measured at the points of a grid, and is a cubic B-spline with these values as coefficients between
/// them, so that contact has continuous second derivatives. normal and curvature are the exact derivatives of the gap
/// that is returned: contact forces conserve energy. Facets and edges come out rounded over the width of a voxel h:
///
/// - Flat faces are exact from four voxels off their edges on, and to 0.003 h from two. A surface with principal
///   curvatures κ₁, κ₂ [1/m], positive on bumps, lies h²/6 (κ₁ + κ₂) inside of the mesh: 6.7 µm on a ball of radius 5
///   cm with h = 1 mm.
/// - The gap on sharp right-angled edges of the mesh is 0.29 h to 0.37 h, on corners 0.45 h to 0.57 h; the surface lies
///   up to 0.5 h inside of the edge. It fills concave edges as much, and nowhere lies outside of the box around the
///   mesh.
/// - The normal has unit length to 0.1 % on a surface with radius of curvature 20 h, and is shorter next to edges: no
///   less than 0.71 on the surface of right-angled ones, where |curvature| reaches 1.0/h (1.2/h below it).
///
/// Inside, distances reach to the medial axis, where the normal vanishes. Outside, they are those of the mesh up to
/// three and a half voxels below the band's width, and level off: beyond the band, the gap is its width and the normal
/// zero. Contact must set in nearer than that.
class MeshObstacle final : public Obstacle {
 public:
  /// @param mesh        closed; check_closed says what that is. It may be inside-out as a whole; where closed parts of
  ///                    it overlap, both the same way round, their union is the body, but depths are measured to the
  ///                    hidden triangles as well
  /// @param voxel_size  h [m]
  /// @param band        how far outside distances are known [m]
  /// @throws std::invalid_argument  what check_closed refuses; voxel_size not positive, more than a quarter of the
  ///                                body's smallest size, or so small that the grid would fill more than 500 MB; a band
  ///                                of less than 4 voxels
  MeshObstacle(const TriangleMesh& mesh, double voxel_size, double band);
  /// With a band of 6 voxels.
  MeshObstacle(const TriangleMesh& mesh, double voxel_size);
  ~MeshObstacle() override;
  MeshObstacle(MeshObstacle&&) noexcept;
  MeshObstacle& operator=(MeshObstacle&&) noexcept;
  MeshObstacle(const MeshObstacle&) = delete;
  MeshObstacle& operator=(const MeshObstacle&) = delete;

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  /// How far the vertex that is worst off is from the body's surface [m]: up to h at a right-angled corner, more at
  /// thinner ones; infinite where the grid shows nothing of what is around a vertex, as on fins thinner than h.
  [[nodiscard]] double rounding() const { return rounding_; }
  /// The box around the mesh.
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return bounds_; }

 private:
  Eigen::AlignedBox3d bounds_;
  double band_;
  double rounding_ = 0;
  std::unique_ptr<const CubicSplineGrid> gap_;
};

}  // namespace sundrape

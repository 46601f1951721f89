#include "mesh_distance.hpp"

#include <algorithm>
#include <cmath>

namespace sundrape {
namespace {

using Corners = std::array<Vector3, 3>;
using Box = Eigen::AlignedBox3d;

double squared_distance_to_segment(const Vector3& x, const Vector3& a, const Vector3& b) {
  const Vector3 along = b - a, to_x = x - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp(to_x.dot(along) / length2, 0.0, 1.0) : 0;
  return (to_x - share * along).squaredNorm();
}

/// The nearest triangle so far, as Eigen::BVIntersect takes it through the tree: boxes that could not better it by more
/// than the tolerance are left alone.
///
/// The search goes depth first. BVMinimize would open the nearest box first, which around the centre of a ball means
/// nearly all boxes before the first triangle.
class Search {
 public:
  Search(const std::vector<Corners>& corners, const Vector3& x, double at_most, double tolerance)
      : corners_(corners), x_(x), tolerance_(tolerance) {
    accept(at_most * at_most, -1);
  }

  // NOLINTBEGIN(readability-identifier-naming): Eigen's names
  [[nodiscard]] bool intersectVolume(const Box& box) const { return box.squaredExteriorDistance(x_) < worthwhile_; }
  bool intersectObject(int triangle) {
    const double d = squared_distance_to_triangle(x_, corners_[static_cast<std::size_t>(triangle)]);
    if (d < least_) accept(d, triangle);
    return false;  // go on
  }
  // NOLINTEND(readability-identifier-naming)

  [[nodiscard]] NearestTriangle result() const { return {std::sqrt(least_), triangle_}; }

 private:
  void accept(double squared_distance, int triangle) {
    least_ = squared_distance;
    triangle_ = triangle;
    const double closer = std::max(0.0, std::sqrt(least_) - tolerance_);
    worthwhile_ = closer * closer;
  }

  const std::vector<Corners>& corners_;
  Vector3 x_;
  double tolerance_;
  double least_ = 0, worthwhile_ = 0;  // squared distances
  int triangle_ = -1;
};

}  // namespace

double squared_distance_to_triangle(const Vector3& x, const std::array<Vector3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vector3 ab = b - a, bc = c - b, ca = a - c, normal = ca.cross(ab);
  // within the prism that stands on the triangle
  if (normal.cross(ab).dot(x - a) > 0 && normal.cross(bc).dot(x - b) > 0 && normal.cross(ca).dot(x - c) > 0) {
    const double height = normal.dot(x - a);
    return height * height / normal.squaredNorm();
  }
  return std::min({squared_distance_to_segment(x, a, b), squared_distance_to_segment(x, b, c),
                   squared_distance_to_segment(x, c, a)});
}

MeshDistance::MeshDistance(const TriangleMesh& mesh) {
  std::vector<int> numbers;
  std::vector<Box> boxes;
  for (const auto& vertices : mesh.triangles) {
    numbers.push_back(static_cast<int>(numbers.size()));
    auto& corners = corners_.emplace_back();
    auto& box = boxes.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh.vertices[static_cast<std::size_t>(vertices[k])];
      box.extend(corners[k]);
    }
  }
  tree_.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
}

NearestTriangle MeshDistance::nearest(const Vector3& x, double at_most, int guess, double tolerance) const {
  Search search(corners_, x, at_most, tolerance);
  if (guess >= 0) search.intersectObject(guess);
  Eigen::BVIntersect(tree_, search);
  return search.result();
}

}  // namespace sundrape

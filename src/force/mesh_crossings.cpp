#include "mesh_crossings.hpp"

#include <algorithm>
#include <cmath>

namespace sundrape {
namespace {

/// Twice the area of the triangle from an edge to the point (x, y), seen from above; its sign says on which side the
/// point lies. Both triangles at an edge get the same number but for the sign, so that no line slips between them.
double side_of_edge(const Vector3& a, int a_number, const Vector3& b, int b_number, double x, double y) {
  if (a_number > b_number) return -side_of_edge(b, b_number, a, a_number, x, y);
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

}  // namespace

MeshCrossings::MeshCrossings(const TriangleMesh& mesh, const VoxelGrid& grid)
    : count_(grid.count), lines_(static_cast<std::size_t>(grid.count[0]) * static_cast<std::size_t>(grid.count[1])) {
  // Lines that run exactly through edges or corners of a mesh with round coordinates could pass either side of them.
  const Vector3 aside(0.61803e-6, 0.41421e-6, 0);
  for (const auto& vertices : mesh.triangles) {
    std::array<Vector3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = (mesh.vertices[static_cast<std::size_t>(vertices[k])] - grid.origin) / grid.spacing + aside;
    add(corners, vertices);
  }
  for (auto& line : lines_) std::ranges::sort(line, {}, [](const Crossing& c) { return std::pair(c.height, c.turn); });
}

void MeshCrossings::add(const std::array<Vector3, 3>& corners, const std::array<int, 3>& vertices) {
  const Vector3 &a = corners[0], &b = corners[1], &c = corners[2];
  const auto first = [&](int k) { return std::max(0, static_cast<int>(std::ceil(std::min({a[k], b[k], c[k]})))); };
  const auto last = [&](int k) {
    return std::min(count_[static_cast<std::size_t>(k)] - 1,
                    static_cast<int>(std::floor(std::max({a[k], b[k], c[k]}))));
  };
  for (int i = first(0); i <= last(0); ++i)
    for (int j = first(1); j <= last(1); ++j) {
      const double at_a = side_of_edge(b, vertices[1], c, vertices[2], i, j);
      const double at_b = side_of_edge(c, vertices[2], a, vertices[0], i, j);
      const double at_c = side_of_edge(a, vertices[0], b, vertices[1], i, j);
      const bool up = at_a > 0 && at_b > 0 && at_c > 0, down = at_a < 0 && at_b < 0 && at_c < 0;
      if (!up && !down) continue;
      const double height = (at_a * a.z() + at_b * b.z() + at_c * c.z()) / (at_a + at_b + at_c);
      lines_[line(i, j)].push_back({height, up ? 1 : -1});
    }
}

std::size_t MeshCrossings::line(int i, int j) const {
  return static_cast<std::size_t>(i) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(j);
}

std::vector<bool> MeshCrossings::inside(int i, int j) const {
  const auto& crossings = lines_[line(i, j)];
  std::vector<bool> points(static_cast<std::size_t>(count_[2]));
  int winding = 0;
  auto next = crossings.begin();
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (; next != crossings.end() && next->height < static_cast<double>(k); ++next) winding += next->turn;
    points[k] = winding != 0;
  }
  return points;
}

}  // namespace sundrape

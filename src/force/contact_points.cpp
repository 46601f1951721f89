#include "sundrape/force/contact_points.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <Eigen/Geometry>

namespace sundrape {

std::vector<ContactPoint> contact_points(std::span<const double> node_areas) {
  std::vector<ContactPoint> points;
  points.reserve(node_areas.size());
  for (std::size_t i = 0; i < node_areas.size(); ++i)
    points.push_back({.nodes = {static_cast<int>(i), -1, -1, -1}, .weights = {1}, .area = node_areas[i]});
  return points;
}

std::vector<ContactPoint> contact_points(const QuadMesh& mesh, int subdivision) {
  if (subdivision < 1) throw std::invalid_argument("contact points cut the sides of a cell into 1 part or more");
  auto points = contact_points(tributary_areas(mesh));
  const double parts = subdivision;
  for (auto& node : points) node.area /= parts * parts;
  std::map<std::pair<int, int>, std::size_t> first_on_edge;
  for (const auto& quad : mesh.quads) {
    const auto x = [&](std::size_t k) { return mesh.reference[static_cast<std::size_t>(quad[k])]; };
    const double part = 0.5 * (x(2) - x(0)).cross(x(3) - x(1)).norm() / (parts * parts);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [i, j] = std::minmax(quad[k], quad[(k + 1) % 4]);
      const auto [place, is_new] = first_on_edge.try_emplace({i, j}, points.size());
      for (int m = 1; m < subdivision; ++m) {
        const double s = m / parts;
        if (is_new) points.push_back({.nodes = {i, j, -1, -1}, .weights = {1 - s, s}});
        points[place->second + static_cast<std::size_t>(m - 1)].area += 0.5 * part;
      }
    }
    for (int m = 1; m < subdivision; ++m)
      for (int n = 1; n < subdivision; ++n) {
        const double s = m / parts, t = n / parts;
        points.push_back(
            {.nodes = quad, .weights = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}, .area = part});
      }
  }
  return points;
}

}  // namespace sundrape

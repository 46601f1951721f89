#include "sundrape/mesh/edges.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace sundrape {

EdgeTable edge_table(const QuadMesh& mesh) {
  struct Side {
    int i, j, quad, corner;
  };
  std::vector<Side> sides;
  sides.reserve(4 * mesh.quads.size());
  for (int e = 0; const auto& quad : mesh.quads) {
    for (int k = 0; k < 4; ++k) {
      const auto [i, j] = std::minmax({quad[static_cast<std::size_t>(k)], quad[static_cast<std::size_t>((k + 1) % 4)]});
      sides.push_back({i, j, e, k});
    }
    ++e;
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.i, s.j, s.quad); });

  EdgeTable table;
  table.quad_edge.resize(mesh.quads.size());
  for (const auto& side : sides) {
    auto& edges = table.edges;
    if (edges.empty() || edges.back().i != side.i || edges.back().j != side.j)
      edges.push_back({side.i, side.j, {side.quad, -1}});
    else if (edges.back().boundary())
      edges.back().quads[1] = side.quad;
    else
      throw std::invalid_argument(
          fmt::format("more than two quads share the edge between nodes {} and {}", side.i, side.j));
    table.quad_edge[static_cast<std::size_t>(side.quad)][static_cast<std::size_t>(side.corner)] =
        static_cast<int>(edges.size()) - 1;
  }
  return table;
}

}  // namespace sundrape

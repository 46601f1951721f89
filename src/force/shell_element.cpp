#include "sundrape/force/shell_element.hpp"

#include "sundrape/mesh/edges.hpp"

namespace sundrape {
namespace {

/// For each quad, whether two opposite edges lie on the boundary.
std::vector<bool> spanning(const QuadMesh& mesh) {
  const auto table = edge_table(mesh);
  std::vector<bool> spans;
  spans.reserve(mesh.quads.size());
  for (const auto& edges : table.quad_edge) {
    const auto free = [&](std::size_t k) { return table.edges[static_cast<std::size_t>(edges[k])].boundary(); };
    spans.push_back((free(0) && free(2)) || (free(1) && free(3)));
  }
  return spans;
}

}  // namespace

std::vector<ShellElement> shell_elements(const QuadMesh& mesh, const std::vector<Vector3>& directors,
                                         std::optional<double> hourglass_factor) {
  const auto spans = spanning(mesh);
  std::vector<ShellElement> elements(mesh.quads.size());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    auto& element = elements[e];
    element.nodes = mesh.quads[e];
    element.spans = spans[e];
    element.hourglass_factor = hourglass_factor.value_or(spans[e] ? 1 : 0.1);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto i = static_cast<std::size_t>(element.nodes[k]);
      element.directors[k] = mesh.nodes() + element.nodes[k];
      element.position[k] = mesh.reference[i];
      element.director[k] = directors[i];
      element.material[k] = mesh.material[i];
    }
  }
  return elements;
}

}  // namespace sundrape

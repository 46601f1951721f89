#include "sundrape/mesh/edge_strains.hpp"

#include <algorithm>

#include "sundrape/mesh/edges.hpp"

namespace sundrape {

EdgeStrains::EdgeStrains(const QuadMesh& mesh) {
  const auto x = [&](int i) { return mesh.reference[static_cast<std::size_t>(i)]; };
  for (const auto& edge : edge_table(mesh).edges) edges_.push_back({edge.i, edge.j, (x(edge.j) - x(edge.i)).norm()});
}

std::pair<double, double> EdgeStrains::range(ConstVectorRef q) const {
  double smallest = 0, largest = 0;
  for (const auto& e : edges_) {
    const double strain = (point(q, e.j) - point(q, e.i)).norm() / e.rest - 1;
    smallest = std::min(smallest, strain);
    largest = std::max(largest, strain);
  }
  return {smallest, largest};
}

EdgeStrains::Stretched EdgeStrains::most_stretched(ConstVectorRef q) const {
  Stretched most;
  for (const auto& e : edges_) {
    const double strain = (point(q, e.j) - point(q, e.i)).norm() / e.rest - 1;
    if (strain > most.strain) most = {e.i, e.j, strain};
  }
  return most;
}

}  // namespace sundrape

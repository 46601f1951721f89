#include "sundrape/mesh/joined.hpp"

#include <algorithm>

namespace sundrape {

std::vector<MeshPiece> pieces_of(std::span<const QuadMesh> sheets, std::span<const std::string> names) {
  std::vector<MeshPiece> pieces;
  MeshPiece next;
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    next.name = names[k];
    next.nodes = sheets[k].nodes();
    next.quads = static_cast<int>(sheets[k].quads.size());
    pieces.push_back(next);
    next.first_node += next.nodes;
    next.first_quad += next.quads;
  }
  return pieces;
}

QuadMesh joined(std::span<const QuadMesh> sheets, std::span<const std::string> names) {
  QuadMesh whole;
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    const auto& sheet = sheets[k];
    const int first = whole.nodes();
    whole.reference.insert(whole.reference.end(), sheet.reference.begin(), sheet.reference.end());
    whole.material.insert(whole.material.end(), sheet.material.begin(), sheet.material.end());
    for (auto quad : sheet.quads) {
      for (auto& n : quad) n += first;
      whole.quads.push_back(quad);
    }
    auto& own = whole.sets[names[k]];
    for (int n = 0; n < sheet.nodes(); ++n) own.push_back(first + n);
    for (const auto& [name, nodes] : sheet.sets)
      for (const int n : nodes) {
        whole.sets[name].push_back(first + n);
        whole.sets[names[k] + "." + name].push_back(first + n);
      }
  }
  return whole;
}

QuadMesh only(const QuadMesh& mesh, const MeshPiece& piece) {
  QuadMesh part{.reference = mesh.reference, .material = mesh.material, .quads = {}, .sets = {}};
  const auto first = mesh.quads.begin() + piece.first_quad;
  part.quads.assign(first, first + piece.quads);
  return part;
}

}  // namespace sundrape

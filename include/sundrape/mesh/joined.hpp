#pragma once
#include <span>
#include <string>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// Where a piece of cloth stands in the mesh of all of them.
struct MeshPiece {
  std::string name;
  int first_node = 0, nodes = 0;
  int first_quad = 0, quads = 0;

  [[nodiscard]] bool has_node(int n) const { return n >= first_node && n < first_node + nodes; }
};

/// Several sheets as one mesh, one after the other.
///
/// A node set of the whole has the nodes of that name of all of them; the sets of a piece alone are "piece.set", and
/// all its nodes "piece".
/// @param names  one a sheet
[[nodiscard]] QuadMesh joined(std::span<const QuadMesh> sheets, std::span<const std::string> names);

/// The pieces of joined(sheets, names).
[[nodiscard]] std::vector<MeshPiece> pieces_of(std::span<const QuadMesh> sheets, std::span<const std::string> names);

/// A mesh with all nodes, but the quads of one piece only; without sets.
[[nodiscard]] QuadMesh only(const QuadMesh& mesh, const MeshPiece& piece);

}  // namespace sundrape

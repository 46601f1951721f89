#pragma once
#include <array>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// One edge of a quad mesh with the quads at it.
struct Edge {
  int i, j;                          // end nodes, i < j
  std::array<int, 2> quads{-1, -1};  // the second is −1 on a boundary

  [[nodiscard]] bool boundary() const { return quads[1] < 0; }
};

/// The edges of a mesh, each once, and how quads find them.
struct EdgeTable {
  std::vector<Edge> edges;                    // by ascending (i, j)
  std::vector<std::array<int, 4>> quad_edge;  // edge between corners k and k + 1 of each quad, E
};

/// @throws std::invalid_argument  an edge with more than two quads
[[nodiscard]] EdgeTable edge_table(const QuadMesh& mesh);

}  // namespace sundrape

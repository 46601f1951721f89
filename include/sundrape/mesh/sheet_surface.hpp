#pragma once
#include <array>
#include <span>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// The surface of sheets as cloth that touches cloth sees it: triangles, every quad being cut from its first corner to
/// its third.
struct SheetSurface {
  struct Edge {
    int i, j;                              // end nodes, i < j
    std::array<int, 2> triangles{-1, -1};  // the second is −1 on a boundary
    double length = 0;                     // at rest [m]
    double area = 0;                       // a third of the triangles at it [m²]

    [[nodiscard]] bool boundary() const { return triangles[1] < 0; }
  };

  std::vector<std::array<int, 3>> triangles;     // two a quad, in the order of the quads
  std::vector<Edge> edges;                       // diagonals of quads too, by ascending (i, j)
  std::vector<double> node_areas;                // a third of the triangles at each node [m²], N
  std::vector<std::vector<int>> node_triangles;  // those at each node, N
  std::vector<bool> on_boundary;                 // N

  SheetSurface() = default;
  /// @throws std::invalid_argument  an edge with more than two quads
  explicit SheetSurface(const QuadMesh& mesh);

  [[nodiscard]] int nodes() const { return static_cast<int>(node_areas.size()); }
};

/// For each node the others that are nearer than `reach` [m] at rest, along edges and diagonals of quads, ascending: N
/// lists. On meshes coarser than that they are empty.
[[nodiscard]] std::vector<std::vector<int>> nodes_within(const QuadMesh& mesh, double reach);

}  // namespace sundrape

#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// A sheet of quadrilaterals: rest shape, warp–weft coordinates, named node sets. Knows no physics.
struct QuadMesh {
  std::vector<Vector3> reference;                // rest positions [m], N
  std::vector<Eigen::Vector2d> material;         // warp and weft coordinate of each node [m], N
  std::vector<std::array<int, 4>> quads;         // nodes counter-clockwise, E
  std::map<std::string, std::vector<int>> sets;  // named node sets: "all", "boundary", a rectangle's edges and corners

  [[nodiscard]] int nodes() const { return static_cast<int>(reference.size()); }
};

/// Area of each quad [m²], E: the product of its two midlines, |m₁ × m₂| = ½ |d₁ × d₂| with its diagonals; exact if
/// flat.
[[nodiscard]] std::vector<double> quad_areas(const QuadMesh& mesh);

/// Tributary area of each node [m²], N: a quarter of the area of every quad at it; sums to the area.
[[nodiscard]] std::vector<double> tributary_areas(const QuadMesh& mesh);

/// Tributary length of each node along the boundary edges whose two ends are both in `nodes` [m], N; 0 elsewhere.
[[nodiscard]] std::vector<double> tributary_edge_lengths(const QuadMesh& mesh, const std::vector<int>& nodes);

/// Diagonal of the rest shape's bounding box [m].
[[nodiscard]] double diagonal(const QuadMesh& mesh);

/// Mean length of the edges at rest [m], each edge counted once.
[[nodiscard]] double mean_edge_length(const QuadMesh& mesh);

/// Unit normal of the sheet at each node, N: the mean of the adjacent quads' normals, weighted by their areas, on the
/// side from which the quads run counter-clockwise.
/// @param positions  N, the rest shape or any placed or deformed one [m]
[[nodiscard]] std::vector<Vector3> node_normals(const QuadMesh& mesh, const std::vector<Vector3>& positions);

/// Nodes on edges that belong to one quad only, ascending.
[[nodiscard]] std::vector<int> boundary_nodes(const QuadMesh& mesh);

/// @throws std::invalid_argument  a quad that names a missing node, repeats one or has no area; a node that no quad
/// uses;
///                                an edge with more than two quads; neighbours that run round in opposite senses;
///                                a position or material coordinate that is missing or not finite
void require_sound(const QuadMesh& mesh);

}  // namespace sundrape

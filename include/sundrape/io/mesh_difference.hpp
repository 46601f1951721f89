#pragma once
#include <string>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// What makes two meshes different in nodes, quads or rest positions; empty if nothing does.
/// @param tolerance  of rest positions, over the diagonal
[[nodiscard]] std::string mesh_difference(const QuadMesh& a, const QuadMesh& b, double tolerance = 1e-9);

/// The same sheet, wavy at rest or not.
constexpr double but_for_waviness = 0.01;

}  // namespace sundrape

#pragma once
#include <string>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// What makes two meshes different in nodes, quads or rest positions (1e-9 of the diagonal); empty if nothing does.
[[nodiscard]] std::string mesh_difference(const QuadMesh& a, const QuadMesh& b);

}  // namespace sundrape

#pragma once
#include <filesystem>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// A sheet of quadrilaterals from a Wavefront OBJ file.
///
/// Reads v, vt, f, g and o; normals, materials and smoothing groups are skipped. Node i is the i-th `v` of the file.
/// Each group (`g`, several names allowed) and object (`o`) becomes the set of the nodes of its faces; "all" and
/// "boundary" are added. Material coordinates are the nodes' vt where the faces have them, else x and y.
/// @param unit  metres per unit of the file, for positions and for vt alike, > 0
/// @throws std::runtime_error     the file cannot be read
/// @throws std::invalid_argument  what the file says is no sheet of quads (require_sound); the message starts with the
///                                file, and the line where one line is to blame
[[nodiscard]] QuadMesh read_obj(const std::filesystem::path& file, double unit);

}  // namespace sundrape

#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include <Eigen/Geometry>

#include "sundrape/types.hpp"

namespace sundrape {

/// A surface of triangles.
///
/// Seen from outside, the vertices of a triangle run counter-clockwise.
struct TriangleMesh {
  std::vector<Vector3> vertices;              // [m]
  std::vector<std::array<int, 3>> triangles;  // vertex numbers, 0 … vertices − 1
};

/// The triangles of a Wavefront OBJ, Stanford PLY or STL file; PLY and STL as text or binary.
///
/// The ending of the file's name (.obj, .ply, .stl) says which. Polygons are cut into triangles; all objects and groups
/// of the file are taken together. Vertices at the same place become one, since STL repeats them for each triangle;
/// triangles that lose a corner by this are dropped. Coordinates are read in single precision.
/// @param unit  metres per unit of the file, > 0
/// @throws std::runtime_error     the file cannot be read
/// @throws std::invalid_argument  the unit, or what the file says is no such mesh; the message starts with the file
[[nodiscard]] TriangleMesh read_triangle_mesh(const std::filesystem::path& file, double unit);

/// Refuses what does not bound a body.
///
/// The whole mesh may be inside-out, with all its normals inwards: what is inside is clear all the same.
/// @throws std::invalid_argument  no triangles; vertices that are not finite or not there; edges with one triangle or
///                                with more than two; neighbours that run opposite ways; no volume. The message counts
///                                them, says where one is and what would do.
void check_closed(const TriangleMesh& mesh);

/// The smallest box around all vertices; empty without any.
[[nodiscard]] Eigen::AlignedBox3d bounds(const TriangleMesh& mesh);

/// Volume that a closed mesh encloses [m³]; negative if it is inside-out.
[[nodiscard]] double volume(const TriangleMesh& mesh);

}  // namespace sundrape

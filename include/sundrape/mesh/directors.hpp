#pragma once
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// Normals of the smooth surface that a mesh stands for, unit, N: the directors of a shell at rest.
///
/// Inside, corners are weighted as sin α/(|e₁||e₂|), which is exact on spheres (Max 1999); at the boundary, where a
/// mean over the quads would lean inwards, the normals of inner neighbours are reflected at the plane half-way, which
/// is exact on spheres too.
[[nodiscard]] std::vector<Vector3> rest_directors(const QuadMesh& mesh);

/// The same directors turned with a sheet that was moved from `from` to `to` [m], N: by as much as its nodes' normals.
[[nodiscard]] std::vector<Vector3> carried_directors(const QuadMesh& mesh, const std::vector<Vector3>& directors,
                                                     const std::vector<Vector3>& from, const std::vector<Vector3>& to);

/// Largest angle between the directors at the two ends of an edge [rad].
/// @param directors  3N, of any length
[[nodiscard]] double sharpest_turn(const QuadMesh& mesh, ConstVectorRef directors);

}  // namespace sundrape

#pragma once
#include <vector>

#include "sundrape/mesh/triangle_mesh.hpp"

#include "voxel_grid.hpp"

namespace sundrape {

/// Signed distance to a closed mesh at every point of a grid [m], negative inside, down to the medial axis.
///
/// Exact outside as far as a band's width, where it ends, and inside as deep as eight spacings; beyond, it may be too
/// large by three hundredths of a spacing. Inside is what the mesh winds around, in whichever sense.
/// @param band  [m], > 0
[[nodiscard]] std::vector<double> voxel_distances(const TriangleMesh& mesh, const VoxelGrid& grid, double band);

}  // namespace sundrape

#include "voxel_distances.hpp"

#include <limits>

#include "mesh_crossings.hpp"
#include "mesh_distance.hpp"

namespace sundrape {

std::vector<double> voxel_distances(const TriangleMesh& mesh, const VoxelGrid& grid, double band) {
  const MeshDistance to_mesh(mesh);
  const MeshCrossings crossings(mesh, grid);
  const double deep = 8 * grid.spacing, freedom = 0.03 * grid.spacing;
  std::vector<double> values(grid.size());
#pragma omp parallel for collapse(2) schedule(dynamic, 16)
  for (int i = 0; i < grid.count[0]; ++i)
    for (int j = 0; j < grid.count[1]; ++j) {
      const auto inside = crossings.inside(i, j);
      NearestTriangle found{0};
      auto* value = &values[grid.number(i, j, 0)];
      for (int k = 0; k < grid.count[2]; ++k, ++value) {
        const bool within = inside[static_cast<std::size_t>(k)];
        // A point beside one that is deeper than this by a spacing is deep as well.
        const double tolerance = within && found.distance > deep + grid.spacing ? freedom : 0;
        const double at_most = within ? std::numeric_limits<double>::infinity() : band;
        found = to_mesh.nearest(grid.point(i, j, k), at_most, found.triangle, tolerance);
        *value = within ? -found.distance : found.distance;
      }
    }
  return values;
}

}  // namespace sundrape

#pragma once
#include <vector>

#include "sundrape/mesh/triangle_mesh.hpp"

#include "voxel_grid.hpp"

namespace sundrape {

/// Where the lines of a grid along z pass through a closed mesh.
class MeshCrossings {
 public:
  MeshCrossings(const TriangleMesh& mesh, const VoxelGrid& grid);

  /// For each point of the line with numbers i along x and j along y: whether the mesh winds around it, in whichever
  /// sense. Points at most a millionth of a spacing from the mesh may be taken for either.
  [[nodiscard]] std::vector<bool> inside(int i, int j) const;

 private:
  struct Crossing {
    double height;  // in spacings from the first point of the line
    int turn;       // 1 if the line comes out through a triangle that faces up, −1 if down
  };

  void add(const std::array<Vector3, 3>& corners, const std::array<int, 3>& vertices);
  [[nodiscard]] std::size_t line(int i, int j) const;

  std::array<int, 3> count_;
  std::vector<std::vector<Crossing>> lines_;
};

}  // namespace sundrape

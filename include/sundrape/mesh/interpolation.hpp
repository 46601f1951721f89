#pragma once
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// Carries fields from the nodes of one mesh of a sheet to those of another: a smooth surface through the first one's
/// nodes.
///
/// Along edges that surface is a cubic with the slopes of parabolas through three nodes of the thread (Catmull, Rom
/// 1974); inside a quad it is the Coons patch of its four edges. It is exact for fields that are linear in the material
/// coordinates, and on even grids for quadratic ones.
class SheetInterpolation {
 public:
  /// Places are matched by material coordinates.
  /// @throws std::invalid_argument  a node of `to` that lies off the sheet of `from`, farther than a curved edge's
  ///                                coarser polygon explains; meshes that have no threads (find_threads)
  SheetInterpolation(const QuadMesh& from, const QuadMesh& to);

  /// field: 3 values a node of `from`; returns 3 a node of `to`.
  /// @throws std::invalid_argument  another length
  [[nodiscard]] Vector carry(ConstVectorRef field) const;

 private:
  int from_nodes_;
  std::vector<std::size_t> start_;  // by node of `to`, one more at the end
  std::vector<int> node_;           // of `from`
  std::vector<double> weight_;
};

}  // namespace sundrape

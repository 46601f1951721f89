#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "sundrape/export/scene.hpp"

namespace sundrape {

/// Cloth and obstacles of a scene as one grid of quadrilaterals and triangles.
class WholeGrid {
 public:
  explicit WholeGrid(const ExportScene& scene);

  std::vector<std::int64_t> connectivity;  // corners, cell after cell
  std::vector<std::int64_t> offsets;       // where each cell's corners begin, and the end
  std::vector<std::int32_t> part;          // of each cell: 0 is the cloth, k the k-th obstacle
  std::size_t points = 0;

  [[nodiscard]] std::size_t cells() const { return part.size(); }
  /// 3 numbers a point [m].
  [[nodiscard]] std::vector<double> positions(const ExportFrame& frame) const;
  [[nodiscard]] std::vector<float> normals(const ExportFrame& frame) const;
  /// Values of a field with NaN at the obstacles' points.
  [[nodiscard]] std::vector<float> field(const Vector& of_nodes) const;
  /// 2 numbers a point, 0 at the obstacles'.
  [[nodiscard]] std::vector<float> texture() const;

 private:
  const ExportScene& scene_;
};

}  // namespace sundrape

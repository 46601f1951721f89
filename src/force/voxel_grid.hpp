#pragma once
#include <array>

#include "sundrape/types.hpp"

namespace sundrape {

/// A regular grid of points with equal spacing: point (i, j, k) is origin + spacing (i, j, k). Values at the points are
/// kept with z running fastest, then y, then x.
struct VoxelGrid {
  Vector3 origin;            // [m]
  double spacing;            // [m]
  std::array<int, 3> count;  // of points along x, y, z

  [[nodiscard]] std::size_t size() const { return length(0) * length(1) * length(2); }
  [[nodiscard]] std::size_t length(std::size_t axis) const { return static_cast<std::size_t>(count[axis]); }
  [[nodiscard]] std::size_t number(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * length(1) + static_cast<std::size_t>(j)) * length(2) +
           static_cast<std::size_t>(k);
  }
  [[nodiscard]] Vector3 point(int i, int j, int k) const { return origin + spacing * Vector3(i, j, k); }
};

}  // namespace sundrape

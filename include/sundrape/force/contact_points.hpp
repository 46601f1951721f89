#pragma once
#include <array>
#include <span>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// A point of the sheet that obstacles push on.
struct ContactPoint {
  std::array<int, 4> nodes{-1, -1, -1, -1};  // those that carry it; unused ones, −1, come last
  std::array<double, 4> weights{};           // its position is Σ weight · node; they sum to 1
  double area = 0;                           // of the cloth that it stands for [m²]

  [[nodiscard]] Vector3 position(const ConstVectorRef& q) const {
    Vector3 x = weights[0] * point(q, nodes[0]);
    for (std::size_t k = 1; k < 4 && nodes[k] >= 0; ++k) x += weights[k] * point(q, nodes[k]);
    return x;
  }
};

/// The nodes alone, with their tributary areas [m²].
[[nodiscard]] std::vector<ContactPoint> contact_points(std::span<const double> node_areas);

/// The corners of all cells when each side is cut into `subdivision` parts, with their tributary areas: cloth between
/// two nodes must not pass through an obstacle's edge. Nodes come first; 1 means nodes alone.
/// @throws std::invalid_argument  subdivision < 1
[[nodiscard]] std::vector<ContactPoint> contact_points(const QuadMesh& mesh, int subdivision);

}  // namespace sundrape

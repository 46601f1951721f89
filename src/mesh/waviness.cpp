#include "sundrape/mesh/waviness.hpp"

#include <cmath>
#include <stdexcept>

#include "sundrape/mesh/noise.hpp"

namespace sundrape {

std::vector<Vector3> wavy(const QuadMesh& mesh, const std::vector<Vector3>& positions, double amplitude,
                          std::uint64_t seed) {
  if (!(amplitude >= 0) || !std::isfinite(amplitude))
    throw std::invalid_argument("the amplitude of the waviness must not be negative");
  Noise noise(seed);
  std::vector<Vector3> moved = positions;
  const auto normals = node_normals(mesh, positions);
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += amplitude * noise() * normals[i];
  return moved;
}

}  // namespace sundrape

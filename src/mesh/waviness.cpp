#include "sundrape/mesh/waviness.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

namespace sundrape {

std::vector<Vector3> wavy(const QuadMesh& mesh, const std::vector<Vector3>& positions, double amplitude,
                          std::uint64_t seed) {
  if (!(amplitude >= 0) || !std::isfinite(amplitude))
    throw std::invalid_argument("the amplitude of the waviness must not be negative");
  // The generator is the same everywhere, the standard distributions are not: take the upper 53 bits as a fraction.
  std::mt19937_64 bits(seed);
  const auto uniform = [&] { return static_cast<double>(bits() >> 11U) * 0x1p-53; };

  std::vector<Vector3> moved = positions;
  const auto normals = node_normals(mesh, positions);
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += amplitude * (2 * uniform() - 1) * normals[i];
  return moved;
}

}  // namespace sundrape

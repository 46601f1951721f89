#pragma once
#include <cstdint>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// A slightly imperfect sheet: every node moved along its normal by a random height, uniform in ± amplitude.
///
/// A perfectly flat symmetric sheet can settle in an unstable equilibrium; waviness lets it fall off. The heights
/// depend on the seed and the node's number alone, on every platform.
/// @param positions  N, where the mesh stands [m]
/// @param amplitude  [m], ≥ 0
/// @return           N positions [m]
/// @throws std::invalid_argument  a negative or infinite amplitude
[[nodiscard]] std::vector<Vector3> wavy(const QuadMesh& mesh, const std::vector<Vector3>& positions, double amplitude,
                                        std::uint64_t seed);

}  // namespace sundrape

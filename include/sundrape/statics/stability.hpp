#pragma once
#include <optional>

#include "sundrape/system/system.hpp"

namespace sundrape {

/// Number of independent ways in which an equilibrium is unstable: negative eigenvalues of its tangent K, by the signs
/// of its factor. Neutral motion (a sheet that slides freely) is not counted: K + ε² M is factored, with ε [1/s] far
/// below the slowest frequency of interest. 0 means stable; nothing if the factorisation breaks down.
[[nodiscard]] std::optional<int> negative_pivots(const System& system, const State& all, double neutral_frequency);

}  // namespace sundrape

#pragma once
#include "sundrape/system/system.hpp"

namespace sundrape {

/// Largest eigenvalue of  (dq ∂f/∂q + dv ∂f/∂v) x = λ diag(weight) x  over the unknowns, by power iteration, which
/// comes from below by about a percent.
/// @param weight  one entry a block row, n, > 0: the masses for squared frequencies or damping rates
[[nodiscard]] double largest_eigenvalue(const System& system, const State& all, double dq, double dv,
                                        ConstVectorRef weight);

}  // namespace sundrape

#pragma once
#include <optional>

#include "sundrape/statics/tangent.hpp"

namespace sundrape {

/// Number of independent ways in which an equilibrium is unstable: negative eigenvalues of its tangent K, by the signs
/// of its factor. Neutral motion is not counted (see Tangent). 0 means stable; nothing if the factorisation breaks
/// down.
[[nodiscard]] std::optional<int> negative_pivots(const System& system, const State& all, double neutral_frequency);

/// An eigenvector of a tangent, K φ = μ φ.
struct Mode {
  double eigenvalue = 0;  // μ [N/m]
  Vector shape;           // φ, rows, 3n, of unit length
};

/// The eigenpairs of the tangent last factored whose eigenvalues are nearest to zero, nearest first, by subspace
/// iteration on the inverse. Eigenvalues are good to about 1e-3 where they stand apart from the next ones.
/// @throws std::runtime_error  where the factor cannot be solved with
[[nodiscard]] std::vector<Mode> modes_nearest_to_zero(const System& system, Tangent& tangent, int count);

/// The most dangerous way in which the equilibrium is unstable: the mode of the most negative eigenvalue among those
/// nearest to zero; nothing where none is negative.
[[nodiscard]] std::optional<Mode> unstable_mode(const System& system, Tangent& tangent);

}  // namespace sundrape

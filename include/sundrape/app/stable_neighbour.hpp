#pragma once
#include <optional>

#include "sundrape/app/model.hpp"
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

/// Where an unstable equilibrium falls to.
struct StableNeighbour {
  RelaxationResult result;    // of all relaxations together
  std::optional<int> pivots;  // negative ones at the end; nothing if that cannot be told
};

/// Pushes an unstable equilibrium under full loads along its most unstable mode, by a thousandth of the sheet's size,
/// and relaxes it; again if it ends on another unstable one.
/// @param q  all points, 3P [m]; an equilibrium before, and after if the relaxation converged
[[nodiscard]] StableNeighbour relax_to_stable_neighbour(const Case& c, const CaseModel& model, Vector& q,
                                                        RelaxationObserver& observer);

/// Frequency below which motion counts as free [1/s]: 10⁻³ √(g/L).
[[nodiscard]] double neutral_frequency(const CaseModel& model);

}  // namespace sundrape

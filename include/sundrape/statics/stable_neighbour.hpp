#pragma once
#include <optional>

#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

/// Where an unstable equilibrium falls to.
struct StableNeighbour {
  RelaxationResult result;    // of all relaxations together
  std::optional<int> pivots;  // negative ones at the end; nothing if that cannot be told
};

/// Pushes an unstable equilibrium along its most unstable mode and relaxes it; again if it ends on another unstable
/// one.
/// @param push               largest displacement of the push [m]
/// @param neutral_frequency  motion slower than this counts as free [1/s]
/// @param q                  all points, 3P [m]; an equilibrium before, and after if the relaxation converged
[[nodiscard]] StableNeighbour relax_to_stable_neighbour(const System& system, LinearSolver& solver,
                                                        const RelaxationOptions& options, double push,
                                                        double neutral_frequency, Vector& q,
                                                        RelaxationObserver& observer);

/// Relaxes a state, and goes on from equilibrium to equilibrium as above until one is stable: to where cloth falls.
/// Parameters as above; q need not be an equilibrium.
[[nodiscard]] StableNeighbour relax_until_stable(const System& system, LinearSolver& solver,
                                                 const RelaxationOptions& options, double push,
                                                 double neutral_frequency, Vector& q, RelaxationObserver& observer);

}  // namespace sundrape

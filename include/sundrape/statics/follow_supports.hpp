#pragma once
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

struct FollowOptions {
  RelaxationOptions relaxation;   // its load factor and stage do not count
  double neutral_frequency = 0;   // [1/s], of Tangent
  double loose_tolerance = 1e-3;  // of the equilibria on the way
};

/// Follows the equilibrium of a sheet whose supports and obstacles move so slowly that inertia does not matter, from
/// one time to a later one.
///
/// Each step predicts along the tangent, K dq/dt = ∂f/∂t, as far as no node moves further than `largest_move`, and
/// relaxes there: where the branch ends the sheet falls to the next equilibrium instead of stopping. Where the tangent
/// is indefinite the supports go alone, by a fifth of that.
/// @param q  all points, 3P [m]: in equilibrium at `from`; at the end where the result says, at its time
struct FollowResult {
  RelaxationResult relaxation;  // counts of all steps; end and residual of the last one
  double time = 0;              // reached [s]
  double work = 0;              // of the supports [J]
};
[[nodiscard]] FollowResult follow_supports(const System& system, LinearSolver& solver, const FollowOptions& options,
                                           double from, double to, Vector& q, RelaxationObserver& observer);

}  // namespace sundrape

#pragma once
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

struct FollowOptions {
  RelaxationOptions relaxation;   // its load factor and stage do not count
  double neutral_frequency = 0;   // [1/s], of Tangent
  double loose_tolerance = 1e-3;  // of the equilibria on the way
  /// How far obstacles carry what is next to the sheet between two times [m]; nothing: they stand still.
  std::function<double(const Vector& q, double from, double to)> way_of_obstacles = {};
};

/// Follows the equilibrium of a sheet whose supports and obstacles move so slowly that inertia does not matter, from
/// one time to a later one.
///
/// Each step carries supports no further than `largest_move` and obstacles no further than a fifth of it, and predicts
/// along the tangent, K dq/dt = ∂f/∂t, as far as no node moves further than `largest_move`. It relaxes there: where the
/// branch ends the sheet falls to the next equilibrium instead of stopping. Where the tangent is indefinite, or the
/// supports only begin to move, they go alone, by a fifth of that.
/// @param q  all points, 3P [m]: in equilibrium at `from`; at the end where the result says, at its time
struct FollowResult {
  RelaxationResult relaxation;  // counts of all steps; end and residual of the last one
  double time = 0;              // reached [s]
  double work = 0;              // of the supports, by the mean of their forces at both ends of each step [J]
};
[[nodiscard]] FollowResult follow_supports(const System& system, LinearSolver& solver, const FollowOptions& options,
                                           double from, double to, Vector& q, RelaxationObserver& observer);

}  // namespace sundrape

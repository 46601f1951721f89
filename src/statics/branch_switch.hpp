#pragma once
#include "path_corrector.hpp"

namespace sundrape {

/// Where a branch has been met.
struct BranchStart {
  PathPoint at;
  Correction found;
  int halvings = 0;    // how often the move along the mode was halved
  int iterations = 0;  // of all tries
};

/// Onto the branch that leaves a bifurcation along its mode (Wagner and Wriggers 1988): a move of
/// `options.branch_amplitude` along it, corrected in the plane normal to it. `found.converged` is false where
/// no try succeeded.
[[nodiscard]] BranchStart start_on_branch(StageSolver& s, const CriticalPoint& bifurcation);

}  // namespace sundrape

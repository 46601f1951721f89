#include "branch_switch.hpp"

namespace sundrape {
namespace {

constexpr int most_halvings = 7;

}  // namespace

BranchStart start_on_branch(StageSolver& s, const CriticalPoint& bifurcation) {
  const Vector along = s.rows(bifurcation.mode);
  BranchStart start;
  for (double amplitude = s.options.branch_amplitude;; amplitude /= 2) {
    start.at = {bifurcation.q, bifurcation.load_factor};
    s.equations.move(start.at.q, amplitude * along, start.at.load_factor);
    start.found = correct_on_plane(s, along, 0, start.at);
    start.iterations += start.found.iterations;
    if (start.found.converged || start.halvings == most_halvings) return start;
    ++start.halvings;
  }
}

}  // namespace sundrape

#include "sundrape/statics/equilibrium_path.hpp"

#include "stage_follower.hpp"

namespace sundrape {

PathResult follow_path(const System& system, const PathOptions& options, PathPosition& at, PathObserver& observer) {
  Tangent tangent(system, options.neutral_frequency);
  if (at.step_q.size() != at.q.size()) at.step_q = Vector::Zero(at.q.size());
  for (; at.stage <= options.stages; ++at.stage) {
    auto result = StageFollower(system, tangent, options, at, observer).run();
    if (result.end != PathEnd::complete || at.stage == options.stages) return result;
    at.load_factor = 0;
    at.arc_length = at.step_load = 0;
    at.step_q.setZero();
  }
  return {};
}

}  // namespace sundrape

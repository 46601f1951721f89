#include "sundrape/force/load_course.hpp"

#include <algorithm>

#include "sundrape/force/smooth_step.hpp"

namespace sundrape {

double LoadCourse::share(const State& state) const {
  if (state.stage <= 0) return last() * (rise > 0 ? smooth_step(state.time / rise) : 1);
  const auto at_end_of = [&](int stage) {
    return stage == 0 ? 0 : stages[std::min(static_cast<std::size_t>(stage), stages.size()) - 1];
  };
  const double before = at_end_of(state.stage - 1);
  return before + state.time * (at_end_of(state.stage) - before);
}

double LoadCourse::share_of_potential(const State& state) const { return state.stage <= 0 ? last() : share(state); }

}  // namespace sundrape

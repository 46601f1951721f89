#include "sundrape/force/path_course.hpp"

#include <algorithm>

#include "sundrape/force/smooth_step.hpp"

namespace sundrape {

double PathTiming::share(const State& state) const {
  if (state.stage > 0) return LoadCourse{0, stages}.share(state);
  const double x = duration > 0 ? (state.time - start) / duration : 1;
  return stages.back() * (profile == Profile::smooth ? smooth_step(x) : std::clamp(x, 0.0, 1.0));
}

double PathTiming::share_rate(const State& state) const {
  if (state.stage != 0 || duration == 0) return 0;
  const double x = (state.time - start) / duration;
  const double slope = profile == Profile::smooth ? smooth_step_rate(x) : (x >= 0 && x < 1 ? 1.0 : 0.0);
  return stages.back() * slope / duration;
}

}  // namespace sundrape

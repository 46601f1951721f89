#include "sundrape/app/rest_watch.hpp"

#include <cmath>
#include <numbers>

#include "sundrape/app/solver_choice.hpp"
#include "sundrape/statics/relaxation.hpp"
#include "sundrape/statics/stability.hpp"

namespace sundrape {
RestWatch::RestWatch(const CaseModel& model, double part, double earliest)
    : system_(*model.system),
      window_(2 * std::numbers::pi * std::sqrt(model.size / model.gravity)),
      earliest_(earliest),
      neutral_frequency_(neutral_frequency(model)) {
  force_scale_ = model.nominal_weight();
  kinetic_limit_ = part * force_scale_ * model.size;
}

void RestWatch::step(const State& all) {
  const bool calm = system_.kinetic_energy(all) <= kinetic_limit_;
  if (calm && !calm_) calm_since_ = all.time;
  calm_ = calm;
  if (!calm || all.time < earliest_ || all.time - calm_since_ < window_) return;
  const Vector still = Vector::Zero(all.v.size());
  const State here{all.time, all.q, still};
  if (relative_residual(system_, here, force_scale_) > balanced) return;
  rests_ = negative_pivots(system_, here, neutral_frequency_).value_or(0) == 0;
  calm_since_ = all.time;  // an unstable one is looked at again after as long
}

}  // namespace sundrape

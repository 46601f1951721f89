#include "sundrape/app/rest_watch.hpp"

#include <cmath>
#include <numbers>

#include "sundrape/statics/relaxation.hpp"

namespace sundrape {
namespace {

constexpr double balance_tolerance = 0.01;

}  // namespace

RestWatch::RestWatch(const CaseModel& model, double part)
    : system_(*model.system), window_(2 * std::numbers::pi * std::sqrt(model.size / model.gravity)) {
  force_scale_ = model.nominal_weight();
  kinetic_limit_ = part * force_scale_ * model.size;
}

void RestWatch::step(const State& all) {
  const bool calm = system_.kinetic_energy(all) <= kinetic_limit_;
  if (calm && !calm_) calm_since_ = all.time;
  calm_ = calm;
  if (!calm || all.time - calm_since_ < window_) return;
  const Vector still = Vector::Zero(all.v.size());
  rests_ = relative_residual(system_, {all.time, all.q, still}, force_scale_) <= balance_tolerance;
}

}  // namespace sundrape

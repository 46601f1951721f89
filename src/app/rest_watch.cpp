#include "sundrape/app/rest_watch.hpp"

#include <cmath>
#include <numbers>

#include "sundrape/statics/relaxation.hpp"

namespace sundrape {
namespace {

constexpr double balance_tolerance = 0.01;

double kinetic_energy(const System& system, const State& all) {
  double twice = 0;
  for (int p = 0; p < static_cast<int>(system.mass().size()); ++p)
    twice += system.mass()[p] * point(all.v, p).squaredNorm();
  return 0.5 * twice;
}

}  // namespace

RestWatch::RestWatch(const CaseModel& model, double part)
    : system_(*model.system), window_(2 * std::numbers::pi * std::sqrt(model.size / model.gravity)) {
  force_scale_ = model.system->mass().head(model.mesh.nodes()).sum() * model.gravity;
  kinetic_limit_ = part * force_scale_ * model.size;
}

void RestWatch::step(const State& all) {
  const bool calm = kinetic_energy(system_, all) <= kinetic_limit_;
  if (calm && !calm_) calm_since_ = all.time;
  calm_ = calm;
  if (!calm || all.time - calm_since_ < window_) return;
  const Vector still = Vector::Zero(all.v.size());
  rests_ = relative_residual(system_, {all.time, all.q, still}, force_scale_) <= balance_tolerance;
}

}  // namespace sundrape

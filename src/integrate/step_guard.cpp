#include "sundrape/integrate/step_guard.hpp"

namespace sundrape {

StepGuard::StepGuard(const System& system) : system_(system) {
  if (!system.watches_passages()) return;
  const auto all = 3 * static_cast<Eigen::Index>(system.unknowns().points());
  for (auto* x : {&from_, &before_, &to_, &still_}) x->setZero(all);
  still_rows_.setZero(system.unknowns().size());
}

void StepGuard::start_from(double time, ConstVectorRef rows_q) {
  if (!watches()) return;
  from_time_ = time;
  system_.expand(time, rows_q, still_rows_, from_, still_);
}

bool StepGuard::admits(double time, ConstVectorRef rows_q) {
  if (!watches()) return true;
  system_.expand(time, rows_q, still_rows_, to_, still_);
  if (!to_.allFinite()) return true;  // others refuse it
  refusal_ = system_.passage({from_time_, from_, still_}, {time, to_, still_});
  return !refusal_;
}

bool StepGuard::settles(double time, ConstVectorRef rows_before, ConstVectorRef rows_after) {
  if (!watches()) return true;
  system_.expand(time, rows_before, still_rows_, before_, still_);
  system_.expand(time, rows_after, still_rows_, to_, still_);
  if (!before_.allFinite() || !to_.allFinite()) return true;  // others refuse it
  return system_.settles({time, before_, still_}, {time, to_, still_});
}

}  // namespace sundrape

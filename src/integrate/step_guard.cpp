#include "sundrape/integrate/step_guard.hpp"

namespace sundrape {

StepGuard::StepGuard(const System& system) : system_(system) {
  if (!system.watches_passages()) return;
  const auto all = 3 * static_cast<Eigen::Index>(system.unknowns().points());
  for (auto* x : {&from_, &to_, &still_}) x->setZero(all);
  still_rows_.setZero(system.unknowns().size());
}

void StepGuard::start_from(double time, ConstVectorRef rows_q) {
  if (from_.size() == 0) return;
  from_time_ = time;
  system_.expand(time, rows_q, still_rows_, from_, still_);
}

bool StepGuard::admits(double time, ConstVectorRef rows_q) {
  if (from_.size() == 0) return true;
  system_.expand(time, rows_q, still_rows_, to_, still_);
  if (!to_.allFinite()) return true;  // others refuse it
  refusal_ = system_.passage({from_time_, from_, still_}, {time, to_, still_});
  return !refusal_;
}

}  // namespace sundrape

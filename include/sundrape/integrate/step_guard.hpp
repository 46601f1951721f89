#pragma once
#include <optional>

#include "sundrape/system/system.hpp"

namespace sundrape {

/// Keeps the steps of an integrator from leading cloth through cloth: from the state that was accepted last, on a
/// straight way.
class StepGuard {
 public:
  explicit StepGuard(const System& system);

  /// A state of the unknowns (rows, 3n) that has been accepted.
  void start_from(double time, ConstVectorRef rows_q);
  /// Whether a step may end with these unknowns.
  [[nodiscard]] bool admits(double time, ConstVectorRef rows_q);
  /// What the last step that was not admitted would have done, unless one was admitted since.
  [[nodiscard]] const std::optional<Passage>& refusal() const { return refusal_; }

 private:
  const System& system_;
  Vector from_, to_, still_rows_, still_;  // all points, unless said otherwise
  double from_time_ = 0;
  std::optional<Passage> refusal_;
};

}  // namespace sundrape

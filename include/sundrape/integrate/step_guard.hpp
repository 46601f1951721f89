#pragma once
#include <optional>

#include "sundrape/system/system.hpp"

namespace sundrape {

/// Keeps the steps of an integrator from leading cloth through cloth: from the state that was accepted last, on a
/// straight way; and Newton's iteration from ending within a barrier before its force is right.
class StepGuard {
 public:
  explicit StepGuard(const System& system);

  /// Whether there is anything to keep from: if not, everything is admitted.
  [[nodiscard]] bool watches() const { return from_.size() > 0; }
  /// A state of the unknowns (rows, 3n) that has been accepted.
  void start_from(double time, ConstVectorRef rows_q);
  /// Whether a step may end with these unknowns.
  [[nodiscard]] bool admits(double time, ConstVectorRef rows_q);
  /// Whether Newton's iteration may end with a correction from one iterate of the unknowns to the next.
  [[nodiscard]] bool settles(double time, ConstVectorRef rows_before, ConstVectorRef rows_after);
  /// What the last step that was not admitted would have done, unless one was admitted since.
  [[nodiscard]] const std::optional<Passage>& refusal() const { return refusal_; }

 private:
  const System& system_;
  Vector from_, before_, to_, still_rows_, still_;  // all points, unless said otherwise
  double from_time_ = 0;
  std::optional<Passage> refusal_;
};

}  // namespace sundrape

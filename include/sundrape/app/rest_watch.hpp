#pragma once
#include "sundrape/app/model.hpp"

namespace sundrape {

/// Says when a motion has come to rest: its kinetic energy has stayed below a part of weight × L for the time
/// 2π√(L/g), a swing of a pendulum as long as the sheet, and the forces without damping balance to 0.01 of the external
/// ones. The time keeps turning points of slow swings out, the forces a creep through thick air.
class RestWatch {
 public:
  /// @param part  of weight × L, > 0
  RestWatch(const CaseModel& model, double part);

  /// To be told of every accepted step.
  void step(const State& all);
  [[nodiscard]] bool rests() const { return rests_; }

 private:
  const System& system_;
  double kinetic_limit_;  // [J]
  double force_scale_;    // stands in for the external force where there is none [N]
  double window_;         // [s]
  double calm_since_ = 0;
  bool calm_ = false, rests_ = false;
};

}  // namespace sundrape

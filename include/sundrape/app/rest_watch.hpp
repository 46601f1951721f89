#pragma once
#include "sundrape/app/model.hpp"

namespace sundrape {

/// Says when a motion has come to rest: its kinetic energy has stayed below a part of weight × L for the time
/// 2π√(L/g), a swing of a pendulum as long as the sheet, and the forces without damping balance to 0.01 of the external
/// ones; not before loads have reached their full size, and not at an unstable equilibrium, which it is only slow to
/// leave. The time keeps turning points of slow swings out, the forces a creep through thick air.
class RestWatch {
 public:
  static constexpr double balanced = 0.01;  // |out-of-balance force| / |external force| of what may be called at rest

  /// @param part  of weight × L, > 0
  /// @param earliest  when loads have reached their full size [s]
  RestWatch(const CaseModel& model, double part, double earliest);

  /// To be told of every accepted step.
  void step(const State& all);
  [[nodiscard]] bool rests() const { return rests_; }

 private:
  const System& system_;
  double kinetic_limit_;      // [J]
  double force_scale_;        // stands in for the external force where there is none [N]
  double window_, earliest_;  // [s]
  double neutral_frequency_;  // [1/s]
  double calm_since_ = 0;
  bool calm_ = false, rests_ = false;
};

}  // namespace sundrape

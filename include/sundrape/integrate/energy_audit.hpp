#pragma once
#include "sundrape/system/system.hpp"

namespace sundrape {

/// Keeps the books of a run's energy: what loads put in, what physics turned into heat, and what the integration method
/// itself lost. Powers are integrated over the accepted steps by the trapezoidal rule.
///
///     method_dissipated = E(0) + external_work − dissipated − E(t),   E = kinetic + stored without the loads' potential
class EnergyAudit {
 public:
  struct Balance {
    Energies energies;
    double dissipated = 0;          // by damping and impacts so far [J]
    double external_work = 0;       // of loads so far [J]
    double method_dissipated = 0;   // by the integration method so far [J]
  };

  /// @param dissipated, external_work  carried over from before a restart [J]; initial_energy likewise, if given
  EnergyAudit(const System& system, const State& all);
  void resume(const Balance& before, double initial_energy);

  /// An accepted step ended here; `impact_loss` is what impacts have turned into heat so far [J].
  void advance(const State& all, double impact_loss);
  /// The balance at a time within the last step, at the state there.
  [[nodiscard]] Balance at(const State& all) const;
  [[nodiscard]] double initial_energy() const { return initial_energy_; }

 private:
  const System& system_;
  double initial_energy_, initial_load_;      // [J]
  double time_ = 0, power_out_ = 0, power_in_ = 0;                 // where the last step ended
  double last_time_ = 0, last_power_out_ = 0, last_power_in_ = 0;  // where it began
  double dissipated_ = 0, fed_in_ = 0, impact_loss_ = 0;           // until where it began [J]
  double carried_work_ = 0;
};

}  // namespace sundrape

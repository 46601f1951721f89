#pragma once
#include "sundrape/system/system.hpp"

namespace sundrape {

/// Keeps the books of a run's energy: what loads put in, what physics turned into heat, and what the integration method
/// itself lost.
///
/// A step's heat is its length times the power at its middle, with rates Δq/h: second order for smooth motion, and
/// blind to what stiff rates at the ends of a step look like, which no error test watches closely. The work of loads,
/// supports and obstacles that move is its length times the mean of the powers at its ends: there stiff forces are in
/// balance, while between two places of a thread that turns they are not.
///
///     method_dissipated = E(0) + external_work − dissipated − E(t),   E = kinetic + stored without the loads'
///     potential
class EnergyAudit {
 public:
  struct Balance {
    Energies energies;
    double dissipated = 0;         // by damping and impacts so far [J]
    double external_work = 0;      // of loads and of supports that move so far [J]
    double method_dissipated = 0;  // by the integration method so far [J]
  };

  /// The books open at a state of all points.
  EnergyAudit(const System& system, const State& all);
  /// Carries over what a run that was interrupted had dissipated and been fed, and the energy that it began with [J].
  void resume(const Balance& before, double initial_energy);

  /// An accepted step ended here; `impact_loss` is what impacts have turned into heat so far [J].
  void advance(const State& all, double impact_loss);
  /// Supports have changed where the last step ended, which may have changed rates too. `before` is the energy until
  /// then, without the loads' potential [J]: what is lost of it counts as heat, what is won as work.
  void supports_changed(const State& all, double before);
  /// The balance at a time within the last step, at the state there.
  [[nodiscard]] Balance at(const State& all) const;
  [[nodiscard]] double initial_energy() const { return initial_energy_; }

 private:
  void close_step();
  [[nodiscard]] double power_in(const State& all) const;

  const System& system_;
  double initial_energy_, initial_load_;  // [J]
  double start_ = 0, end_ = 0;            // of the last step [s]
  double power_out_ = 0, power_in_ = 0;   // over the last step [W]
  double power_in_now_ = 0;               // when it ended [W]
  double dissipated_ = 0, fed_in_ = 0;    // until the last step began [J]
  double impact_loss_ = 0;
  double held_kinetic_ = 0;  // of what is held and carried, when the last step ended [J]
  Vector q_;                 // where the last step ended, 3P
  Vector middle_, rate_;     // work
  double carried_work_ = 0;
};

}  // namespace sundrape

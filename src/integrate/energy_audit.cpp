#include "sundrape/integrate/energy_audit.hpp"

#include <cmath>

namespace sundrape {
EnergyAudit::EnergyAudit(const System& system, const State& all) : system_(system) {
  const auto e = system.energies(all);
  initial_energy_ = e.total() - e.load;
  initial_load_ = e.load;
  start_ = end_ = all.time;
  q_ = all.q;
  held_kinetic_ = system.held_kinetic_energy(all);
  power_in_now_ = power_in(all);
}

double EnergyAudit::power_in(const State& all) const {
  return system_.external_power(all) + (system_.has_motions() ? system_.support_power(all) : 0.0);
}

void EnergyAudit::resume(const Balance& before, double initial_energy) {
  dissipated_ = before.dissipated;
  carried_work_ = before.external_work;
  initial_energy_ = initial_energy;
}

void EnergyAudit::close_step() {
  dissipated_ += (end_ - start_) * power_out_;
  fed_in_ += (end_ - start_) * power_in_;
  start_ = end_;
  power_out_ = power_in_ = 0;
}

void EnergyAudit::supports_changed(const State& all, double before) {
  close_step();
  const auto e = system_.energies(all);
  const double lost = before - (e.total() - e.load);
  (lost > 0 ? dissipated_ : fed_in_) += std::abs(lost);
  power_in_now_ = power_in(all);
  held_kinetic_ = system_.held_kinetic_energy(all);
  q_ = all.q;
}

void EnergyAudit::advance(const State& all, double impact_loss) {
  close_step();
  impact_loss_ = impact_loss;
  end_ = all.time;
  if (end_ > start_) {
    middle_ = 0.5 * (q_ + all.q);
    rate_ = (all.q - q_) / (end_ - start_);
    const State middle{0.5 * (start_ + end_), middle_, rate_};
    power_out_ = system_.dissipated_power(middle);
    const double now = power_in(all), held = system_.held_kinetic_energy(all);
    power_in_ = 0.5 * (power_in_now_ + now) + (held - held_kinetic_) / (end_ - start_);
    power_in_now_ = now;
    held_kinetic_ = held;
  }
  q_ = all.q;
}

EnergyAudit::Balance EnergyAudit::at(const State& all) const {
  const double part = all.time - start_;
  Balance b;
  b.energies = system_.energies(all);
  b.dissipated = dissipated_ + impact_loss_ + part * power_out_;
  b.external_work = carried_work_ + initial_load_ - b.energies.load + fed_in_ + part * power_in_;
  b.method_dissipated = initial_energy_ + b.external_work - b.dissipated - (b.energies.total() - b.energies.load);
  return b;
}

}  // namespace sundrape

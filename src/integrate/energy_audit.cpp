#include "sundrape/integrate/energy_audit.hpp"

namespace sundrape {
namespace {

/// ∫ of a power that is linear between (t0, p0) and (t1, p1), from t0 to t.
double energy_until(double t, double t0, double p0, double t1, double p1) {
  if (!(t1 > t0)) return 0;
  const double x = (t - t0) / (t1 - t0);
  return (t - t0) * (p0 + 0.5 * x * (p1 - p0));
}

}  // namespace

EnergyAudit::EnergyAudit(const System& system, const State& all) : system_(system) {
  const auto e = system.energies(all);
  initial_energy_ = e.total() - e.load;
  initial_load_ = e.load;
  time_ = last_time_ = all.time;
  power_out_ = last_power_out_ = system.dissipated_power(all);
  power_in_ = last_power_in_ = system.external_power(all);
}

void EnergyAudit::resume(const Balance& before, double initial_energy) {
  dissipated_ = before.dissipated;
  carried_work_ = before.external_work;
  initial_energy_ = initial_energy;
}

void EnergyAudit::advance(const State& all, double impact_loss) {
  dissipated_ += energy_until(time_, last_time_, last_power_out_, time_, power_out_);
  fed_in_ += energy_until(time_, last_time_, last_power_in_, time_, power_in_);
  last_time_ = time_;
  last_power_out_ = power_out_;
  last_power_in_ = power_in_;
  time_ = all.time;
  power_out_ = system_.dissipated_power(all);
  power_in_ = system_.external_power(all);
  impact_loss_ = impact_loss;
}

EnergyAudit::Balance EnergyAudit::at(const State& all) const {
  Balance b;
  b.energies = system_.energies(all);
  b.dissipated = dissipated_ + impact_loss_ + energy_until(all.time, last_time_, last_power_out_, time_, power_out_);
  b.external_work = carried_work_ + initial_load_ - b.energies.load + fed_in_ + energy_until(all.time, last_time_, last_power_in_, time_, power_in_);
  b.method_dissipated = initial_energy_ + b.external_work - b.dissipated - (b.energies.total() - b.energies.load);
  return b;
}

}  // namespace sundrape

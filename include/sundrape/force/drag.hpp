#pragma once
#include "sundrape/force/force_term.hpp"

namespace sundrape {

/// Mass-proportional damping, −α M v: drag against air at rest, which rigid motion does feel.
class Drag final : public ForceTerm {
 public:
  /// @param mass  P [kg]
  /// @param rate  α [1/s], ≥ 0
  /// @throws std::invalid_argument  α < 0
  Drag(Vector mass, double rate);

  [[nodiscard]] std::string_view name() const override { return "drag"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::none; }
  [[nodiscard]] double energy(const State& /*state*/) const override { return 0; }
  [[nodiscard]] double dissipated_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

 private:
  Vector mass_;
  double rate_;
};

}  // namespace sundrape

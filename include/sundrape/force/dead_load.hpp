#pragma once
#include <string>

#include "sundrape/force/force_term.hpp"
#include "sundrape/force/load_course.hpp"

namespace sundrape {

/// Nodal forces that keep their size and direction: weight, nodal forces, edge tractions.
///
/// Stored energy −F·q, so that a load that is there from the start needs no bookkeeping of work. While it rises only
/// the share λ(t) of F acts, and the rest, (λ − 1) F·v, counts as power from outside. In staged statics the energy is
/// −λ F·q.
class DeadLoad final : public ForceTerm {
 public:
  /// @param forces  3P [N]
  DeadLoad(std::string name, EnergyKind kind, Vector forces, LoadCourse course = {});

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] EnergyKind kind() const override { return kind_; }
  [[nodiscard]] bool is_external() const override { return true; }
  [[nodiscard]] double energy(const State& state) const override {
    return -course_.share_of_potential(state) * forces_.dot(state.q);
  }
  [[nodiscard]] double external_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override { f += course_.share(state) * forces_; }
  void add_tangent(const State& /*state*/, double /*dq*/, double /*dv*/, Assembler& /*tangent*/) const override {}
  void declare_pattern(Pattern& pattern) const override { pattern.begin_term(1); }

 private:
  std::string name_;
  EnergyKind kind_;
  Vector forces_;
  LoadCourse course_;
};

/// Weight of point masses [kg] under an acceleration [m/s²] as nodal forces, 3P [N].
[[nodiscard]] Vector weight(const Vector& mass, const Vector3& acceleration);

}  // namespace sundrape

#pragma once
#include <vector>

#include "sundrape/force/force_term.hpp"

namespace sundrape {

/// A director that wants to stay unit.
struct DirectorSpring {
  int point = 0;         // of the director
  double stiffness = 0;  // E h A of the cloth at its node [J]
};

/// Keeps directors unit by the elasticity across the thickness: W = ½ E h A ε₃₃², ε₃₃ = ½ (|t|² − 1).
///
/// It is smooth through any rotation and needs no parameters of one (chapter (7) is singular where E·t = −1).
/// Kelvin–Voigt damping adds β E h A dε₃₃/dt.
class DirectorLength final : public ForceTerm {
 public:
  /// @param director_length  ℓ [m]: a director's point is ℓ times the director
  /// @param relaxation_time  β [s], ≥ 0
  /// @throws std::invalid_argument  ℓ not positive, β < 0, or a stiffness that is not positive
  DirectorLength(std::vector<DirectorSpring> springs, double director_length, double relaxation_time = 0);

  [[nodiscard]] std::string_view name() const override { return "director length"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::shear; }
  [[nodiscard]] double energy(const State& state) const override;
  void add_strain_energy(const State& state, VectorRef of_points) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

  /// Largest | |t| − 1 | of all directors.
  [[nodiscard]] double largest_error(ConstVectorRef q) const;

 private:
  [[nodiscard]] double stored(const DirectorSpring& spring, const State& state) const;  // [J]

  std::vector<DirectorSpring> springs_;
  double length_, relaxation_time_;
};

}  // namespace sundrape

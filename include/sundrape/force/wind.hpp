#pragma once
#include <array>
#include <vector>

#include "sundrape/force/force_term.hpp"
#include "sundrape/force/load_course.hpp"
#include "sundrape/force/wind_field.hpp"

namespace sundrape {

/// Drag and lift of air on every face, quadratic in the velocity u of the air as the face sees it.
///
/// With the area vector a of a face, A = |a| and s = u·a,
///     D = ½ ρ C_d r u,  r² = s² + (ε A |u|)²,        L = ½ ρ C_l (s |u| a/A − s² u/(A |u|)).
/// ε = 0.01 is what friction along a face adds, a hundredth of the drag across; D would have a kink without it. L is
/// normal to u, so D·u alone turns energy into heat, in the air. A quarter of a face's force goes to each node.
/// The air is not moved: a sheet feels neither its own wake nor that of others, nor air that is caught below it.
class Wind final : public ForceTerm {
 public:
  /// @throws std::invalid_argument  a negative density or coefficient, a period that is not positive
  Wind(std::vector<std::array<int, 4>> faces, WindField field, AirCoefficients air, LoadCourse course = {});

  [[nodiscard]] std::string_view name() const override { return "wind"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::none; }
  [[nodiscard]] bool is_external() const override { return true; }
  [[nodiscard]] bool has_symmetric_tangent() const override { return false; }
  [[nodiscard]] double energy(const State& /*state*/) const override { return 0; }
  [[nodiscard]] double dissipated_power(const State& state) const override;
  [[nodiscard]] double external_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

 private:
  struct Face;
  [[nodiscard]] Face face(const std::array<int, 4>& nodes, const State& state, const Vector3& wind) const;

  std::vector<std::array<int, 4>> faces_;
  WindField field_;
  AirCoefficients air_;
  LoadCourse course_;
};

}  // namespace sundrape

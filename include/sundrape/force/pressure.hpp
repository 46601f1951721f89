#pragma once
#include <array>
#include <vector>

#include "sundrape/force/force_term.hpp"
#include "sundrape/force/load_course.hpp"

namespace sundrape {

/// Pressure on the faces, along their current normals (counter-clockwise side), on their current areas.
///
/// A face with diagonals D₁, D₂ has the area vector ½ D₁×D₂; a quarter of its force goes to each node.
class Pressure final : public ForceTerm {
 public:
  /// @param pressure  [Pa], positive along the normal of the counter-clockwise side
  Pressure(std::vector<std::array<int, 4>> faces, double pressure, LoadCourse course = {});

  [[nodiscard]] std::string_view name() const override { return "pressure"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::none; }
  [[nodiscard]] bool is_external() const override { return true; }
  [[nodiscard]] bool has_symmetric_tangent() const override { return false; }
  [[nodiscard]] double energy(const State& /*state*/) const override { return 0; }
  [[nodiscard]] double external_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

 private:
  std::vector<std::array<int, 4>> faces_;
  double pressure_;
  LoadCourse course_;
};

}  // namespace sundrape

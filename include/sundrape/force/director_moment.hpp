#pragma once
#include <vector>

#include "sundrape/force/force_term.hpp"
#include "sundrape/force/load_course.hpp"

namespace sundrape {

struct LoadedDirector {
  int point = 0;   // of the director
  Vector3 moment;  // [N m], fixed in space
};

/// Moments on the directors of a shell: the couple f = m × t/|t|² on each, whose work is m·δθ.
///
/// The axis stays where it is while the sheet turns. Such a moment has no potential; what it does is external power.
class DirectorMoment final : public ForceTerm {
 public:
  explicit DirectorMoment(std::vector<LoadedDirector> directors, LoadCourse course = {});

  [[nodiscard]] std::string_view name() const override { return "moment"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::none; }
  [[nodiscard]] bool is_external() const override { return true; }
  [[nodiscard]] double energy(const State& /*state*/) const override { return 0; }
  [[nodiscard]] double external_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

 private:
  std::vector<LoadedDirector> directors_;
  LoadCourse course_;
};

}  // namespace sundrape

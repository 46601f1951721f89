#pragma once
#include <vector>

#include "sundrape/force/force_term.hpp"
#include "sundrape/force/load_course.hpp"

namespace sundrape {

/// The last edge of a thread that ends at a loaded node, and the moment that it carries.
struct LoadedEdge {
  int inner = 0, end = 0;  // e = x_end − x_inner
  Vector3 moment;          // [N m], fixed in space
};

/// A moment on an edge of the sheet, applied as couples on the last edges of its threads.
///
/// The couple ±F with F = M×e/|e|² turns with the edge and has the moment of M about every axis across e; nothing turns
/// an edge about itself. In a plane it has the potential −M θ; in space it has none, and its tangent is not symmetric.
class EdgeMoment final : public ForceTerm {
 public:
  explicit EdgeMoment(std::vector<LoadedEdge> edges, LoadCourse course = {});

  [[nodiscard]] std::string_view name() const override { return "edge moment"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::none; }
  [[nodiscard]] bool is_external() const override { return true; }
  [[nodiscard]] double energy(const State& /*state*/) const override { return 0; }
  [[nodiscard]] double external_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

 private:
  std::vector<LoadedEdge> edges_;
  LoadCourse course_;
};

}  // namespace sundrape

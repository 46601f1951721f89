#pragma once
#include <vector>

#include "sundrape/force/element_table.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/force/stripes.hpp"

namespace sundrape {

/// A straight spring between two nodes: a thread segment, or a diagonal of a cell.
struct StretchSpring {
  int i = 0, j = 0;      // end nodes
  double length = 0;     // rest length b [m]
  double stiffness = 0;  // E h w / b [N/m], w the tributary width of cloth that the spring stands for
};

/// Stretching of the particle net along its edges.
///
/// Each spring stores  W = ½ D' k (|x_j − x_i| − b)²  with k = E h w / b, so its force is D' E h w Δb/b along the
/// thread (chapter, equations (36)–(38), where w = b for every edge). D' = 1 in tension and `compression_factor` in
/// compression. Kelvin–Voigt damping adds β k d|x_j − x_i|/dt, which rigid motion does not feel.
class StretchSprings final : public ForceTerm {
 public:
  /// @param relaxation_time     β of the Kelvin–Voigt damping [s], ≥ 0
  /// @param compression_factor  D' for shortened springs, in [0, 1]
  /// @throws std::invalid_argument  out of range, or a spring without length or stiffness
  StretchSprings(const std::vector<StretchSpring>& springs, EnergyKind kind, double relaxation_time = 0,
                 double compression_factor = 1);

  [[nodiscard]] std::string_view name() const override { return "stretch springs"; }
  [[nodiscard]] EnergyKind kind() const override { return kind_; }
  [[nodiscard]] double energy(const State& state) const override;
  void add_strain_energy(const State& state, VectorRef of_points) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

 private:
  enum Number { length, stiffness };
  struct Stretched;
  [[nodiscard]] Stretched stretched(std::size_t first, const State& state, double relaxation_time) const;

  ElementTable<2, 2> table_;
  EnergyKind kind_;
  double relaxation_time_;
  double compression_factor_;
  Stripes stripes_;
};

}  // namespace sundrape

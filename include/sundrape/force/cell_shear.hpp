#pragma once
#include <array>
#include <vector>

#include "sundrape/force/element_table.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/force/stripes.hpp"

namespace sundrape {

/// One cell of the net that resists shearing in its plane.
struct ShearCell {
  std::array<int, 4> nodes;  // counter-clockwise
  double scale = 0;          // |mean warp edge| · |mean weft edge| at rest [m²]
  double rest = 0;           // |x₃ − x₁|² − |x₄ − x₂|² at rest [m²]
  double stiffness = 0;      // B' G h A [J], A the cell's area
};

/// In-plane shear of the particle net, along the diagonals of its cells.
///
/// With diagonals D₁ = x₃ − x₁ and D₂ = x₄ − x₂ the mean edges p, q of a cell obey 4 p·q = |D₁|² − |D₂|², so
/// γ = (|D₁|² − |D₂|² − rest) / (4 |p₀||q₀|) is the shear angle φ of chapter (39) to first order. The stored energy
/// ½ B' G h A γ² pulls along the diagonals only, as the chapter's forces (43) do; two springs per cell would do the
/// same for small shear, but they also stiffen the threads (by G/E) and resist twisting the cell, which this measure
/// does not. Kelvin–Voigt damping adds β B' G h A dγ/dt.
class CellShear final : public ForceTerm {
 public:
  /// @param relaxation_time  β [s], ≥ 0
  /// @throws std::invalid_argument  β < 0, or a cell without area or stiffness
  explicit CellShear(const std::vector<ShearCell>& cells, double relaxation_time = 0);

  [[nodiscard]] std::string_view name() const override { return "cell shear"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::shear; }
  [[nodiscard]] double energy(const State& state) const override;
  void add_strain_energy(const State& state, VectorRef of_points) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

 private:
  enum Number { half_per_scale, rest, stiffness };
  struct Sheared;
  [[nodiscard]] Sheared sheared(std::size_t first, const State& state) const;

  ElementTable<4, 3> table_;
  double relaxation_time_;
  Stripes stripes_;
};

}  // namespace sundrape

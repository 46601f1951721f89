#pragma once
#include <vector>

#include "sundrape/force/element_table.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/force/shell_element.hpp"
#include "sundrape/force/stripes.hpp"

namespace sundrape {

struct ShellOptions {
  MembraneField membrane = MembraneField::centre;
  CurvatureMeasure curvature = CurvatureMeasure::geodesic;
  double director_length = 1;  // ℓ [m]: a director's point is ℓ times the director
};

/// The geometrically exact shell (chapter §2 and appendix) on quadrilaterals with a position φ and a director t at each
/// node, both interpolated bilinearly, the director without normalisation; docs/shell.md derives it.
///
/// Strains (3)–(5): membrane by one of the fields, transverse shear tied at the middles of the edges (MITC4), bending
/// at 2×2 points. Every strain is a polynomial of degree two in the unknowns but for the geodesic factor, so that
/// gradient and tangent are exact and short. Directors enter as points of length ℓ, in metres like positions; what
/// keeps them unit is DirectorLength. Kelvin–Voigt damping adds β C dε/dt, with the rigidities at κ = 0 for bending.
class Shell final : public ForceTerm {
 public:
  /// @throws std::invalid_argument  an element that is not convex, a director length that is not positive, damping < 0
  Shell(const std::vector<ShellElement>& elements, const ShellSection& section, const ShellOptions& options);

  [[nodiscard]] std::string_view name() const override { return "shell"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::membrane; }
  [[nodiscard]] double energy(const State& state) const override;
  void add_energies(const State& state, Energies& energies) const override;
  void add_strain_energy(const State& state, VectorRef of_points) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;
  [[nodiscard]] bool has_symmetric_tangent() const override { return section_.bending.is_symmetric(); }

 private:
  // Columns of the table of elements; matrices by the rows of their upper triangles.
  enum Number : std::size_t {
    membrane = 0,                   // 6 × 6
    membrane_rest = membrane + 21,  // 6
    shear = membrane_rest + 6,      // 4 × 4
    shear_rest = shear + 10,        // 4
    bending = shear_rest + 4,       // 3 × 3 at each point of integration, covariant; linear, or at κ = 0
    curvature_rest = bending + 24,  // 8
    frame = curvature_rest + 8,     // 3 × 3 at each point, not symmetric
    area = frame + 36,              // 4
    spans = area + 4,               // 1 in elements that span the sheet, else 0
    numbers = spans + 1
  };
  class Element;

  ShellSection section_;
  ShellOptions options_;
  ElementTable<8, numbers> table_;  // nodes, then directors
  Stripes stripes_;
};

}  // namespace sundrape

#pragma once
#include <array>
#include <optional>
#include <vector>

#include "sundrape/force/element_table.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/force/stripes.hpp"
#include "sundrape/material/moment_curvature.hpp"

namespace sundrape {

/// Two consecutive edges of a thread line and the thread that crosses them.
struct BendSpring {
  int previous = 0, centre = 0, next = 0;  // nodes along the thread
  int cross_from = 0, cross_to = 0;        // ends of the crossing chord; one of them is the centre on a boundary
  double skew = 0;                         // the hinge axis is (x_to − x_from) − skew (x_next − x_previous)
  double rest_angle = 0;                   // [rad]
  double stiffness = 0;                    // B w / s [N m]: bending rigidity, tributary width, length along the thread
  double length = 0;                       // s [m], which only a law of bending needs
};

/// Bending of the particle net between consecutive edges of its thread lines.
///
/// The angle Δφ between the edges about the crossing thread is curvature times length, Δφ = s/R, and the moment is
/// M = EI/(1 − ν²)/R (chapter (45)); each spring stores ½ (B w/s) (Δφ − Δφ₀)². The pairs of forces that the chapter
/// writes as F_bend = M/b (44), (47) are its gradient. Kelvin–Voigt damping adds β (B w/s) dΔφ/dt.
///
/// With a law M = f(K) of the thread's strips, K = (Δφ − Δφ₀)/s, a spring stores (B w s/f'(0)) ∫f dK instead
/// (BendResponse); B is then the rigidity at K = 0, and the damping stays that of B.
///
/// Beyond 150° a barrier keeps the edges from closing upon each other (FoldLimit), and no step may turn a spring
/// through π: it would fold the thread through itself, unseen by contact, which leaves neighbours alone.
class BendSprings final : public ForceTerm {
 public:
  /// @param relaxation_time  β [s], ≥ 0
  /// @param law              of all these springs, up to a factor; linear if there is none
  /// @throws std::invalid_argument  β < 0, a stiffness that is not positive, a spring that names a node twice, or one
  ///                                with a law but without length
  explicit BendSprings(const std::vector<BendSpring>& springs, double relaxation_time = 0,
                       std::optional<MomentCurvature> law = std::nullopt);

  [[nodiscard]] std::string_view name() const override { return "bend springs"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::bending; }
  [[nodiscard]] double energy(const State& state) const override;
  void add_strain_energy(const State& state, VectorRef of_points) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;
  [[nodiscard]] bool watches_passages() const override { return true; }
  [[nodiscard]] std::optional<Passage> passage(const State& from, const State& to) const override;
  [[nodiscard]] bool settles(const State& before, const State& after) const override;

  /// Largest |Δφ| over all springs [rad]: near π the net folds more sharply than its mesh can follow.
  [[nodiscard]] double largest_angle(ConstVectorRef q) const;

 private:
  enum Number { skew, rest_angle, stiffness, length };
  struct Edges;
  [[nodiscard]] Edges edges(std::size_t first, ConstVectorRef x) const;
  struct Stored;  // energies of several springs
  [[nodiscard]] Stored stored(std::size_t first, ConstVectorRef q) const;
  /// Whether a spring lies inside a sheet of straight crossing threads, as most do.
  [[nodiscard]] bool is_plain(std::size_t e) const;
  struct Stencil;
  [[nodiscard]] Stencil stencil(std::size_t e) const;

  // previous, centre, next, then the ends of the crossing chord: on a boundary one of them is the centre
  ElementTable<5, 4> table_;
  double relaxation_time_;
  std::optional<MomentCurvature> law_;  // none: linear
  Stripes stripes_;
};

}  // namespace sundrape

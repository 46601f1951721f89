#pragma once
#include <optional>
#include <vector>

#include "sundrape/force/force_term.hpp"
#include "sundrape/force/path_course.hpp"
#include "sundrape/material/moment_curvature.hpp"

namespace sundrape {

/// The first edge of a thread that leaves a clamped node.
struct ClampSpring {
  int node = 0, next = 0;
  Vector3 direction;     // the slope that the clamp holds, along the thread [-]
  Vector3 axis;          // hinge axis, in the sheet and across the thread [-]
  double stiffness = 0;  // B w / (b/2) [N m]
  double length = 0;     // b/2 [m], which only a law of bending needs
};

/// Clamped edges of the particle net hold the slope.
///
/// An edge of length b has the slope of the thread at its middle, b/2 from the clamp, so the angle φ between clamp and
/// edge stores ½ (B w/(b/2)) φ². With it the moment- and tip-loaded cantilevers converge with second order.
/// With a law M = f(K), K = φ/(b/2), it stores (B w (b/2)/f'(0)) ∫f dK instead (BendResponse).
class ClampSprings final : public ForceTerm {
 public:
  /// @param relaxation_time  β [s], ≥ 0
  /// @param law              of all these springs, up to a factor; linear if there is none
  /// @throws std::invalid_argument  β < 0, a stiffness that is not positive, or a law and a spring without length
  explicit ClampSprings(std::vector<ClampSpring> springs, double relaxation_time = 0,
                        std::optional<MomentCurvature> law = std::nullopt);

  /// The clamps of these nodes turn with a body that is carried along a path; several of one node follow each other.
  void turn_with(const std::vector<int>& nodes, const PathCourse& course);
  /// The clamps of these nodes hold no slope any more.
  void open(const std::vector<int>& nodes);

  [[nodiscard]] std::string_view name() const override { return "clamped edges"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::bending; }
  [[nodiscard]] double energy(const State& state) const override;
  void add_strain_energy(const State& state, VectorRef of_points) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  [[nodiscard]] double external_power(const State& state) const override;
  void add_force(const State& state, VectorRef f) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

  /// Σ (x_next − x_node) × force on `next` over the clamped nodes that are in `nodes` (N entries) [N m]: the moment
  /// that their clamps put on the sheet.
  [[nodiscard]] Vector3 couple(const State& state, const std::vector<bool>& nodes) const;

 private:
  /// A spring as its clamp stands now, with the edge and its rate as seen from the clamp.
  struct Held {
    Vector3 direction, axis, edge, rate, spin;
  };
  /// How the bodies that clamps turn with stand at a state, one a course.
  struct Turns {
    std::vector<Matrix3> rotation;
    std::vector<Vector3> spin;  // [1/s]
  };
  [[nodiscard]] Turns turns(const State& state) const;
  [[nodiscard]] Held held(std::size_t spring, const Turns& turns, const State& state) const;
  [[nodiscard]] double stored(const ClampSpring& spring, const Held& held) const;  // [J]
  /// What draws the end of a spring's edge back, −force on `next` [N].
  [[nodiscard]] Vector3 pull(const ClampSpring& spring, const Held& held) const;

  std::vector<ClampSpring> springs_;
  std::vector<PathCourse> courses_;
  std::vector<std::vector<std::size_t>> turned_by_;  // courses of each spring's clamp, in their order
  double relaxation_time_;
  std::optional<MomentCurvature> law_;  // none: linear
};

}  // namespace sundrape

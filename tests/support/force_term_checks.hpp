#pragma once
#include "sundrape/force/force_term.hpp"

namespace sundrape {

/// Random coordinates around a jittered grid of spacing `scale`, and random rates: nothing is straight, at rest or
/// aligned.
struct TestState {
  double time = 0;
  Vector q, v;
  [[nodiscard]] operator State() const {
    return {time, q, v};
  }  // NOLINT(google-explicit-constructor): reads as a state
};
[[nodiscard]] TestState random_state(int points, unsigned seed, double scale = 0.01);
/// Given nodes moved by uniform noise of ± amplitude, with random rates of ± `speed`.
[[nodiscard]] TestState perturbed(const std::vector<Vector3>& nodes, double amplitude, double speed, unsigned seed);

/// The whole tangent of a term, dense: dq ∂f/∂q + dv ∂f/∂v, as an unsymmetric or a symmetric matrix keeps it.
[[nodiscard]] Eigen::MatrixXd dense_tangent(const ForceTerm& term, const State& state, double dq, double dv,
                                            Symmetry symmetry);

/// Force against central differences of the energy (where there is one), tangent against central differences of the
/// force, `relative` bounding |difference| / |largest entry|; and for v = 0, where no damping turns with its spring,
/// the tangent as symmetric matrices get it against the symmetric part of the whole one.
void expect_force_is_energy_gradient(const ForceTerm& term, const TestState& state, double relative = 1e-6);
void expect_tangent_is_force_derivative(const ForceTerm& term, const TestState& state, double relative = 1e-6);
void expect_symmetric_tangent_is_symmetric_part(const ForceTerm& term, const TestState& state, double relative = 1e-12);
void expect_consistent(const ForceTerm& term, const TestState& state, double relative = 1e-6);

/// Symmetric part of ∂f/∂v is negative semi-definite and v·f_damping = −dissipated power.
void expect_dissipates_what_it_says(const ForceTerm& term, const TestState& state, double relative = 1e-10);

/// A rest shape that is moved as a rigid body, with rigid velocities: no force, no dissipation.
void expect_no_force_under_rigid_motion(const ForceTerm& term, const std::vector<Vector3>& rest, double force_scale);

/// Forces and their moments about the origin sum to zero in any state.
void expect_self_equilibrated(const ForceTerm& term, const TestState& state, double relative = 1e-10);

}  // namespace sundrape

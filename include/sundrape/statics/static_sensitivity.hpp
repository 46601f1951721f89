#pragma once
#include "sundrape/statics/tangent.hpp"
#include "sundrape/system/parameter_derivative.hpp"

namespace sundrape {

/// How the equilibria of a system move with parameters: 0 = f(q(p), p) gives
///     K s = |p| ∂f/∂p,   K = −∂f/∂q,   s = |p| dq/dp,
/// one solve a parameter by a factor of the tangent at the equilibrium, contact included.
class StaticSensitivity {
 public:
  StaticSensitivity(const System& system, double neutral_frequency)
      : system_(system), tangent_(system, neutral_frequency), forces_(system) {}

  /// Factors the tangent at an equilibrium; false where it is singular.
  [[nodiscard]] bool move_to(const State& equilibrium);
  /// s of all points, 3P [m], held ones included; nothing where the solve fails.
  [[nodiscard]] std::optional<Vector> derivative(ParameterDerivative& by);

 private:
  const System& system_;
  Tangent tangent_;
  TermForces forces_;
  double time_ = 0;
  int stage_ = 0;
  Vector q_;
};

}  // namespace sundrape

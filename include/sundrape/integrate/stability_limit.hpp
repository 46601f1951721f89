#pragma once
#include "sundrape/system/system.hpp"

namespace sundrape {

/// The stiffest mode of a system and what it allows an explicit method.
struct StabilityLimit {
  double angular_frequency = 0;  // ω of the stiffest mode, √ of the largest eigenvalue of M⁻¹K [1/s]
  double damping_rate = 0;       // largest eigenvalue of M⁻¹C [1/s]
  double step = 0;               // largest stable step of the classical Runge–Kutta method [s]
};

/// Of nodes that touch an obstacle.
struct ContactRates {
  double angular_frequency = 0;  // (stiffness over mass)½ [1/s]
  double damping_rate = 0;       // of friction that holds, over mass [1/s]
};

/// Estimates the stiffest mode at a state by power iteration on M⁻¹K and M⁻¹C, and with it the step h at which the
/// amplification |R(hλ)| of the classical Runge–Kutta method, R(z) = 1 + z + z²/2 + z³/6 + z⁴/24, passes 1 for
/// λ² + c λ + ω² = 0: h ω = 2√2 without damping, h c ≈ 2.785 where damping rules. Both eigenvalues come from below, by
/// about a percent.
/// @param contact  what the start does not show
[[nodiscard]] StabilityLimit rk4_stability_limit(const System& system, const State& all,
                                                 const ContactRates& contact = {});

/// Largest stable step for one mode with frequency ω [1/s] and damping rate c [1/s].
[[nodiscard]] double rk4_stable_step(double angular_frequency, double damping_rate);

}  // namespace sundrape

#pragma once
#include "sundrape/material/moment_curvature.hpp"

namespace sundrape {

/// A bend spring that follows a law of strips, M = f(K), against the linear one of its stiffness k = B w/s, B = f'(0).
///
/// A spring of length s and width w that turns by Δφ has the curvature K = Δφ/s, stores w s ∫f dK and carries the
/// moment w f(K) (article (15), times the plate factor that k holds as well). Over k that is what these three say:
///     moment = k · turn,    dM/dΔφ = k · slope,    energy = k · energy.
/// A linear law has turn = Δφ, slope = 1, energy = ½ Δφ².
template <class Real>
struct BendResponse {
  Real turn;    // s f(Δφ/s)/B [rad]
  Real slope;   // f'(Δφ/s)/B [-]
  Real energy;  // s² ∫f dK/B [rad²]
};

/// @param length  s [m]
/// @param angle   Δφ from rest [rad]
/// @tparam Real   double, or a SIMD batch of them
template <class Real>
[[nodiscard]] BendResponse<Real> bend_response(const MomentCurvature& law, const Real& length, const Real& angle) {
  const auto strip = law.at(Real(angle / length));
  const Real compliance(1 / law.initial_rigidity()), scaled = length * compliance;
  return {scaled * strip.moment, compliance * strip.slope, length * scaled * strip.energy};
}

}  // namespace sundrape

#pragma once
#include <Eigen/Core>

#include "sundrape/material/moment_curvature.hpp"

namespace sundrape {

/// A strip that bends in the x–z plane and neither stretches nor shears, clamped at one end: the exact solution of
/// which nets and shells are approximations. All quantities are per width of the strip.
///
/// s runs from the clamp (0) to the tip (L), θ(s) is the slope from +x towards +z, so x' = cos θ, z' = sin θ, and the
/// curvature is K = θ'. What lies beyond s pulls at the cut with the force
///     N(s) = F − (0, w (L − s))
/// and turns it with the moment M = f(K), positive if it raises θ'. The piece ds is in balance about its start if
///     dM + (x' N_z − z' N_x) ds = 0, hence
///     d/ds f(θ') = (w (L − s) − F_z) cos θ + F_x sin θ,      θ(0) = clamp_angle,   f(θ'(L)) = 0.
/// A strip that sags from a horizontal clamp has θ < 0 and M < 0; with the slope counted downwards, ψ = −θ, the same
/// reads d/ds f(ψ') = −w (L − s) cos ψ.
struct PlanarElastica {
  MomentCurvature law;                                  // M = f(K) [N] against [1/m]
  double length = 1;                                    // L [m]
  double weight = 0;                                    // w, per area, towards −z [N/m²]
  Eigen::Vector2d tip_force = Eigen::Vector2d::Zero();  // F, dead: x and z [N/m]
  double clamp_angle = 0;                               // [rad]

  struct Shape {
    Eigen::Vector2d tip;        // from the clamp: x and z [m]
    double tip_angle = 0;       // θ(L) [rad]
    double root_moment = 0;     // M(0) [N]
    double root_curvature = 0;  // θ'(0) [1/m]
    double error = 0;           // change of the tip's place against half as many steps [m]
  };

  /// Shooting from the tip, where M = 0, for the slope there with which the root meets the clamp: Newton's method along
  /// growing loads, so of several equilibria the one that grows out of the straight strip. Integration by the classical
  /// Runge–Kutta method in `steps` equal steps.
  /// @throws std::runtime_error  where Newton's method fails
  [[nodiscard]] Shape solve(int steps = 1000) const;
};

}  // namespace sundrape

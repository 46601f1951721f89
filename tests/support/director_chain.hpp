#pragma once
#include <vector>

#include <Eigen/Core>

#include "sundrape/material/moment_curvature.hpp"

namespace sundrape {

/// What a strip of shell elements is in a plane, if it neither stretches nor shears: n edges of length a = L/n between
/// nodes whose directors have turned by θ_0 = 0 (the clamp), θ_1 … θ_n from +z towards −x. Per width of the strip.
///
/// A transverse shear that vanishes at the middle of an edge makes the edge normal to the mean of its two directors:
/// its slope is (θ_{k−1} + θ_k)/2. The geodesic curvature of an element is (θ_k − θ_{k−1})/a; the chord's, (17), is 2
/// sin((θ_k − θ_{k−1})/2)/a. With Φ = ∫f dK and the weight of each half of an edge in its node,
///     W = a Σ Φ(K_k) + Σ_k (w (L − s_k) − F) a sin((θ_{k−1} + θ_k)/2) − m θ_n,    s_k = (k − ½) a.
/// Newton's method on ∂W/∂θ = 0 along growing loads.
struct DirectorChain {
  MomentCurvature law;    // M = f(K) [N] against [1/m]
  double length = 1;      // L [m]
  double weight = 0;      // w, per area, towards −z [N/m²]
  double tip_force = 0;   // F, towards +z, per width [N/m]
  double tip_moment = 0;  // m, in the sense of θ, per width [N]
  bool chord = false;     // curvature from chords

  struct Shape {
    Eigen::Vector2d tip;  // from the clamp: x and z [m]
    double tip_angle;     // θ_n [rad]
  };
  /// @throws std::runtime_error  where Newton's method fails
  [[nodiscard]] Shape solve(int elements) const;
};

}  // namespace sundrape

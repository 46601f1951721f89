#pragma once
#include <functional>
#include <vector>

#include <Eigen/Core>

namespace sundrape {

/// A heavy strip as n rigid links, hinged at springs that follow its law, clamped horizontally: what a second-order
/// method makes of the planar elastica, by the minimum of its energy instead of by shooting. Per width of the strip.
///
/// With θ_i the slope of link i (from +x towards +z), b = L/n and Φ = ∫f dK,
///     W = ½ b Φ(2 θ₁/b) + b Σ Φ((θ_{i+1} − θ_i)/b) + w b Σ (L − s_i) sin θ_i,    s_i = (i − ½) b,
/// since the middle of link i and all beyond it are lifted with sin θ_i. Newton's method on ∂W/∂θ = 0.
struct RigidChain {
  std::function<double(double)> moment, slope;  // f(K) [N] and f'(K) [N m], for K ≥ 0 [1/m]; f is odd
  double length = 1;                            // L [m]
  double weight = 0;                            // w [N/m²]

  /// Place of the tip, x and z [m].
  /// @throws std::runtime_error  where Newton's method fails
  [[nodiscard]] Eigen::Vector2d tip(int links) const;
};

}  // namespace sundrape

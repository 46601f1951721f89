#pragma once
#include "sundrape/types.hpp"

namespace sundrape {

/// How friction enters the matrix of Newton's iteration: by its true derivative by the velocity, or by its secant.
enum class FrictionMatrix { secant, tangent };

/// Coulomb's friction, made smooth at rest: a force −μ N φ(s/s₀) along the velocity of sliding, of speed s.
///
/// φ(x) = 1 − (1 − x)³ up to x = 1 and 1 beyond: C² there, and at rest viscous with 3 μ N/s₀. What is held creeps:
/// under a part r < 1 of the largest friction at  s₀ (1 − (1 − r)^⅓),  so always slower than s₀.
class FrictionLaw {
 public:
  /// @param speed  s₀, the fastest creep of what friction holds [m/s]
  /// @throws std::invalid_argument  unless it is positive
  explicit FrictionLaw(double speed);

  [[nodiscard]] double speed() const { return speed_; }
  /// φ/s [s/m]: the force is −μ N (φ/s) v.
  [[nodiscard]] double over_speed(double s) const;
  /// d(φ/s)/ds / s [s³/m³]; 0 at s = 0, where nothing that it is multiplied with matters.
  [[nodiscard]] double slope_over_speed(double s) const;

 private:
  double speed_;
};

}  // namespace sundrape

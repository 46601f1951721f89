#pragma once
#include <array>

#include "sundrape/force/friction_law.hpp"
#include "sundrape/force/separation.hpp"

namespace sundrape {

/// Friction of one pair that presses with N, F_k = −μ N (φ(s)/s) w_k v, and its derivatives; v = Σ w_k v_k without its
/// part along the normal, s = |v|.
class ClothFriction {
 public:
  /// @param velocities  of the points [m/s]
  ClothFriction(const Separation& separation, const Vector3& normal, const std::array<Vector3, 4>& velocities,
                double coefficient, double push, const FrictionLaw& law, FrictionMatrix matrix);

  /// What derivatives by place need besides: N changes by −slope n·Σ w_k dx_k, and by `pressure_area` Σ crossing_k ·
  /// dx_k.
  void prepare_by_place(const std::array<Vector3, 4>& x, const std::array<Vector3, 4>& velocities,
                        const SeparationHessian& turning, double slope, double pressure_area,
                        const std::array<Vector3, 4>& crossing);

  [[nodiscard]] Matrix3 by_velocity(std::size_t k, std::size_t l) const;  // ∂F_k/∂v_l
  [[nodiscard]] Matrix3 by_place(std::size_t k, std::size_t l) const;     // ∂F_k/∂x_l, once prepared

 private:
  const Separation& separation_;
  Vector3 normal_, relative_, sliding_;
  double over_speed_, coefficient_, push_;
  Matrix3 along_;                                      // 1 − n nᵀ
  Matrix3 by_sliding_;                                 // ∂F/∂v, F = Σ F_k over the first shape
  std::array<Vector3, 2> joint_{}, slide_velocity_{};  // ∂r/∂s and ∂(Σ w v)/∂s
  std::array<std::array<Vector3, 4>, 2> slide_{};      // ∂s/∂x_l
  std::array<Vector3, 4> push_gradient_{};             // ∂N/∂x_l
};

}  // namespace sundrape

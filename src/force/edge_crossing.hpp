#pragma once
#include <array>

#include "sundrape/types.hpp"

namespace sundrape {

/// How much two edges, from x₀ to x₁ and from x₂ to x₃, cross:  c = y (2 − y),  y = |u × v|²/γ₀ up to 1, and 1 beyond,
/// with its derivatives by x. Where edges become parallel the nearest points jump along them; forces times c do not
/// (C. Li et al., "Incremental potential contact", 2020, (24)).
struct EdgeCrossing {
  double factor = 1;
  std::array<Vector3, 4> gradient{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};

  EdgeCrossing() = default;  // of what always counts fully
  EdgeCrossing(const std::array<Vector3, 4>& x, double parallel2) : u_(x[1] - x[0]), v_(x[3] - x[2]) {
    const double uu = u_.squaredNorm(), vv = v_.squaredNorm(), uv = u_.dot(v_);
    const double y = (uu * vv - uv * uv) / parallel2;
    if (y >= 1) return;
    factor = y * (2 - y);
    slope_ = 2 * (1 - y) / parallel2;
    curvature_ = -2 / (parallel2 * parallel2);
    by_u_ = 2 * (vv * u_ - uv * v_);
    by_v_ = 2 * (uu * v_ - uv * u_);
    gradient = {-slope_ * by_u_, slope_ * by_u_, -slope_ * by_v_, slope_ * by_v_};
  }
  [[nodiscard]] bool is_constant() const { return slope_ == 0; }

  /// ∂²c/∂x_k∂x_l
  [[nodiscard]] Matrix3 hessian(std::size_t k, std::size_t l) const {
    const double sign = (k % 2 == l % 2) ? 1 : -1;
    const bool first_k = k < 2, first_l = l < 2;
    const Vector3 &a = first_k ? by_u_ : by_v_, &b = first_l ? by_u_ : by_v_;
    Matrix3 second;  // of |u × v|²
    if (first_k == first_l) {
      const Vector3& other = first_k ? v_ : u_;
      second = 2 * (other.squaredNorm() * Matrix3::Identity() - other * other.transpose());
    } else {
      const Vector3 &own = first_k ? u_ : v_, &other = first_k ? v_ : u_;
      second = 2 * (2 * own * other.transpose() - other * own.transpose() - u_.dot(v_) * Matrix3::Identity());
    }
    return sign * (slope_ * second + curvature_ * a * b.transpose());
  }

 private:
  Vector3 u_ = Vector3::Zero(), v_ = Vector3::Zero();
  Vector3 by_u_ = Vector3::Zero(), by_v_ = Vector3::Zero();  // of |u × v|²
  double slope_ = 0, curvature_ = 0;                         // of c by |u × v|²
};

}  // namespace sundrape

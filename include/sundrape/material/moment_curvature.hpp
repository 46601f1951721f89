#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace sundrape {

/// Moment per width against curvature of a strip, M = f(K): linear, or a polynomial fitted to a bending test.
///
/// The chapter's fit (15) holds for 0 ≤ K ≤ K_max. It is extended as an odd function (its even powers make it 5 to 13
/// times too stiff at K < 0 if taken literally), and past K_max by the slope that it has there.
class MomentCurvature {
 public:
  static constexpr std::size_t most_terms = 9;

  /// M = B K.
  /// @param rigidity  B [N m], > 0
  /// @throws std::invalid_argument  out of range
  [[nodiscard]] static MomentCurvature linear(double rigidity);
  /// M = Σ α_k K^k, k = 1, 2, …
  /// @param coefficients   α_k [N m^k], 1 to `most_terms` of them
  /// @param max_curvature  K_max, where the fit ends [1/m], > 0
  /// @throws std::invalid_argument  out of range, or a law whose moment does not grow all the way to K_max
  [[nodiscard]] static MomentCurvature polynomial(std::span<const double> coefficients, double max_curvature);

  /// The law with every moment multiplied. @param factor  > 0
  [[nodiscard]] MomentCurvature scaled(double factor) const;

  /// The slope at the origin [N m].
  [[nodiscard]] double initial_rigidity() const { return alpha_[0]; }
  [[nodiscard]] bool is_linear() const { return linear_; }
  /// α_k [N m^k].
  [[nodiscard]] std::span<const double> coefficients() const { return {alpha_.data(), terms_}; }
  /// K_max [1/m], of a linear law far past any curvature.
  [[nodiscard]] double max_curvature() const { return max_; }

  template <class Real>
  struct Response {
    Real moment;  // M [N]
    Real slope;   // dM/dK [N m]
    Real energy;  // ∫ M dK, per area [N/m]
  };

  /// @tparam Real  double, or a SIMD batch of them
  template <class Real>
  [[nodiscard]] Response<Real> at(const Real& curvature) const {
    using std::abs, std::copysign, std::min;
    const Real size = abs(curvature), inside = min(size, Real(max_)), beyond = size - inside;
    Real moment(0.0), slope(0.0), energy(0.0);  // Horner's scheme, moment and energy without their powers of K
    for (std::size_t k = terms_; k-- > 0;) {
      const auto power = static_cast<double>(k + 1);
      moment = moment * inside + Real(alpha_[k]);
      slope = slope * inside + Real(power * alpha_[k]);
      energy = energy * inside + Real(alpha_[k] / (power + 1));
    }
    moment = moment * inside;
    energy = energy * inside * inside + beyond * (moment + Real(0.5) * slope * beyond);
    moment = moment + slope * beyond;
    return {copysign(moment, curvature), slope, energy};
  }

 private:
  std::array<double, most_terms> alpha_{};
  std::size_t terms_ = 0;
  double max_ = 0;
  bool linear_ = false;
};

}  // namespace sundrape

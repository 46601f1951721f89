#pragma once
#include <Eigen/Core>

#include "sundrape/material/moment_curvature.hpp"

namespace sundrape {

/// Moments of a sheet against its curvatures, in local orthonormal warp–weft axes: m = (m₁₁, m₂₂, m₁₂) [N] against
/// κ = (κ₁₁, κ₂₂, 2κ₁₂) [1/m], the twist being the engineering one everywhere.
///
/// Three ways from strips to sheets, the same for linear strips of an isotropic fabric:
/// - `linear`   m = D κ with constant, symmetric D.
/// - `paper`    equations (32)–(34) where the axes are orthonormal:
///                m₁₁ = (f₁(κ₁₁) + ν f₂(κ₂₂))/(1 − ν²),  m₂₂ = (ν f₁(κ₁₁) + f₂(κ₂₂))/(1 − ν²),
///                m₁₂ = ½ f̄(2κ₁₂)/(1 + ν),  f̄ = (f₁ + f₂)/2.
///              With ν ≠ 0 it has no energy and its tangent is not symmetric; bending oblique to the threads follows
///              another law than bending along them.
/// - `energy`   W = ½ (Q₁ φ₁(K) + Q₂ φ₂(K))/(1 − ν²) with φ_i(K) = 2 ∫f_i dK/K², Q₁ + Q₂ = K² and
///                Q_i = κ_ii² + ν κ₁₁ κ₂₂ + ¼ (1 − ν) (2κ₁₂)².
///              For f₁ = f₂ it is the strip's energy at one equivalent curvature K, the same whatever the direction
///              of bending, convex, and with the moments of (32), (33) wherever a sheet bends into a cylinder along a
///              thread.
class PlateBending {
 public:
  enum class Form { linear, paper, energy };

  template <class Real>
  struct Response {
    Eigen::Matrix<Real, 3, 1> moment;
    Eigen::Matrix<Real, 3, 3> tangent;  // ∂m/∂κ, rows for m
    Real energy;                        // per area [N/m]; of `paper`, which has none, that of `energy`
  };

  PlateBending() = default;
  /// @param rigidity  D [N m], symmetric and positive definite
  /// @throws std::invalid_argument  if it is not
  explicit PlateBending(const Eigen::Matrix3d& rigidity);
  /// @param warp, weft  of strips cut along either thread, per width
  /// @param poisson     ν, in [0, 0.5)
  /// @throws std::invalid_argument  out of range, Form::linear, or laws too different for ν: ν (B₁ + B₂)/2 ≥ √(B₁ B₂)
  PlateBending(Form form, const MomentCurvature& warp, const MomentCurvature& weft, double poisson);

  [[nodiscard]] Form form() const { return form_; }
  [[nodiscard]] bool is_symmetric() const { return form_ != Form::paper || poisson_ == 0; }
  /// D, of a nonlinear law the symmetric part of its tangent at κ = 0 [N m].
  [[nodiscard]] const Eigen::Matrix3d& rigidity() const { return rigidity_; }

  /// @tparam Real  double, or a SIMD batch of them
  template <class Real>
  [[nodiscard]] Response<Real> at(const Eigen::Matrix<Real, 3, 1>& curvature) const;

 private:
  template <class Real>
  [[nodiscard]] Response<Real> linear(const Eigen::Matrix<Real, 3, 1>& curvature) const;
  template <class Real>
  [[nodiscard]] Response<Real> paper(const Eigen::Matrix<Real, 3, 1>& curvature) const;
  template <class Real>
  [[nodiscard]] Response<Real> from_energy(const Eigen::Matrix<Real, 3, 1>& curvature) const;

  Form form_ = Form::linear;
  MomentCurvature warp_, weft_;
  double poisson_ = 0;
  Eigen::Matrix3d rigidity_ = Eigen::Matrix3d::Zero();
};

template <class Real>
PlateBending::Response<Real> PlateBending::at(const Eigen::Matrix<Real, 3, 1>& curvature) const {
  if (form_ == Form::linear) return linear(curvature);
  return form_ == Form::paper ? paper(curvature) : from_energy(curvature);
}

template <class Real>
PlateBending::Response<Real> PlateBending::linear(const Eigen::Matrix<Real, 3, 1>& curvature) const {
  Response<Real> r;
  r.tangent = rigidity_.template cast<Real>();
  r.moment = r.tangent * curvature;
  r.energy = Real(0.5) * r.moment.dot(curvature);
  return r;
}

template <class Real>
PlateBending::Response<Real> PlateBending::paper(const Eigen::Matrix<Real, 3, 1>& curvature) const {
  const Real plate(1 / (1 - poisson_ * poisson_)), nu(poisson_), half(0.25 / (1 + poisson_));
  const auto f1 = warp_.at(curvature[0]), f2 = weft_.at(curvature[1]);
  const auto t1 = warp_.at(curvature[2]), t2 = weft_.at(curvature[2]);
  Response<Real> r;
  r.moment = {plate * (f1.moment + nu * f2.moment), plate * (nu * f1.moment + f2.moment),
              half * (t1.moment + t2.moment)};
  r.tangent.setConstant(Real(0.0));
  r.tangent(0, 0) = plate * f1.slope;
  r.tangent(0, 1) = plate * nu * f2.slope;
  r.tangent(1, 0) = plate * nu * f1.slope;
  r.tangent(1, 1) = plate * f2.slope;
  r.tangent(2, 2) = half * (t1.slope + t2.slope);
  r.energy = from_energy(curvature).energy;
  return r;
}

template <class Real>
PlateBending::Response<Real> PlateBending::from_energy(const Eigen::Matrix<Real, 3, 1>& curvature) const {
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using std::max, std::sqrt;
  const Real plate(1 / (1 - poisson_ * poisson_)), half(0.5), nu(poisson_), twist(0.25 * (1 - poisson_));
  const Real k1 = curvature[0], k2 = curvature[1], t = curvature[2];
  const Real shared = nu * k1 * k2 + twist * t * t, q1 = k1 * k1 + shared, q2 = k2 * k2 + shared;
  const Vector g1(Real(2.0) * k1 + nu * k2, nu * k1, Real(2.0) * twist * t),
      g2(nu * k2, Real(2.0) * k2 + nu * k1, Real(2.0) * twist * t), g = g1 + g2;
  // far below any curvature that matters: there the laws are linear
  const Real z = max(q1 + q2, Real(1e-12)), equivalent = sqrt(z);
  struct Along {  // φ and its derivatives by z = K²
    Real value, first, second;
  };
  const auto along = [&](const MomentCurvature& law) -> Along {
    const auto f = law.at(equivalent);
    const Real secant = f.moment / equivalent, value = Real(2.0) * f.energy / z, first = (secant - value) / z;
    return {value, first, (half * (f.slope - secant) / z - Real(2.0) * first) / z};
  };
  const Along a = along(warp_), b = along(weft_);
  const Real change = half * (q1 * a.first + q2 * b.first), bent = half * (q1 * a.second + q2 * b.second);

  Response<Real> r;
  r.energy = plate * half * (q1 * a.value + q2 * b.value);
  r.moment = plate * (half * (a.value * g1 + b.value * g2) + change * g);
  const Vector c = half * (a.first * g1 + b.first * g2);
  r.tangent = c * g.transpose();
  r.tangent += g * (c + bent * g).transpose();
  r.tangent(0, 0) += a.value + Real(2.0) * change;
  r.tangent(1, 1) += b.value + Real(2.0) * change;
  const Real coupling = nu * (half * (a.value + b.value) + Real(2.0) * change);
  r.tangent(0, 1) += coupling;
  r.tangent(1, 0) += coupling;
  r.tangent(2, 2) += twist * (a.value + b.value + Real(4.0) * change);
  r.tangent *= plate;
  return r;
}

}  // namespace sundrape

#pragma once
#include <cmath>

#include <Eigen/Geometry>

#include "sundrape/types.hpp"

namespace sundrape {

/// The angle from edge a to edge b about an axis c, with its derivatives.
///
/// φ = atan2((a×b)·c, |c| a·b − (a·c)(b·c)/|c|): the turn of a thread about the thread that crosses it. Turning an
/// edge towards c, in the plane of both, leaves φ alone, so it measures bending out of the sheet and no shear inside
/// it; φ has a sign, and it is smooth through a straight thread. All vectors in metres, φ in (−π, π).
///
/// Real is double, or a batch of doubles: one hinge a lane.
template <class Real>
struct BasicHingeAngle {
  using Vector = Eigen::Matrix<Real, 3, 1>;

  Real angle;
  Vector ga, gb, gc;  // ∂φ/∂a, ∂φ/∂b, ∂φ/∂c [1/m]

  BasicHingeAngle(const Vector& a, const Vector& b, const Vector& c);
};

/// The second derivatives that do not vanish (∂²φ/∂a∂b = 0) [1/m²]; ac is ∂²φ/∂a∂c with rows for a.
template <class Real>
struct BasicHingeCurvature {
  using Vector = Eigen::Matrix<Real, 3, 1>;

  Eigen::Matrix<Real, 3, 3> aa, bb, ac, bc, cc;

  BasicHingeCurvature(const Vector& a, const Vector& b, const Vector& c);
};

using HingeAngle = BasicHingeAngle<double>;
using HingeCurvature = BasicHingeCurvature<double>;

namespace hinge {

/// Turning arm a about c by one radian changes φ by one, so ∂φ/∂(arm) = |c| (c×a)/|c×a|², negative for the first arm.
template <class Real>
Eigen::Matrix<Real, 3, 1> turn(const Eigen::Matrix<Real, 3, 1>& arm, const Eigen::Matrix<Real, 3, 1>& axis,
                               const Real& axis_length) {
  const Eigen::Matrix<Real, 3, 1> lever = axis.cross(arm);
  return (axis_length / lever.squaredNorm()) * lever;
}

/// Derivatives of `turn` by the arm and by the axis.
template <class Real>
struct TurnGradient {
  Eigen::Matrix<Real, 3, 3> by_arm, by_axis;

  TurnGradient(const Eigen::Matrix<Real, 3, 1>& arm, const Eigen::Matrix<Real, 3, 1>& axis, const Real& axis_length) {
    const Eigen::Matrix<Real, 3, 1> lever = axis.cross(arm);
    const Real per_square = Real(1) / lever.squaredNorm(), per_length = Real(1) / axis_length;
    const Eigen::Matrix<Real, 3, 1> scaled = per_square * lever;
    for (int i = 0; i < 3; ++i) {
      // row i of ∂turn/∂lever, which is symmetric; lever = axis × arm
      Eigen::Matrix<Real, 3, 1> by_lever = (Real(-2) * axis_length * scaled[i]) * scaled;
      by_lever[i] += axis_length * per_square;
      by_arm.row(i) = by_lever.cross(axis).transpose();
      by_axis.row(i) = ((scaled[i] * per_length) * axis - by_lever.cross(arm)).transpose();
    }
  }
};

}  // namespace hinge

template <class Real>
BasicHingeAngle<Real>::BasicHingeAngle(const Vector& a, const Vector& b, const Vector& c) {
  using std::atan2, std::sqrt;
  const Real square = c.squaredNorm(), length = sqrt(square), per_square = Real(1) / square;
  const Real ac = a.dot(c), bc = b.dot(c);
  angle = atan2(a.cross(b).dot(c), length * (a.dot(b) - ac * bc * per_square));
  ga = -hinge::turn(a, c, length);
  gb = hinge::turn(b, c, length);
  // φ does not change under a common rotation, nor with the length of c
  gc = (-ac * per_square) * ga - (bc * per_square) * gb;
}

template <class Real>
BasicHingeCurvature<Real>::BasicHingeCurvature(const Vector& a, const Vector& b, const Vector& c) {
  using std::sqrt;
  const Real square = c.squaredNorm(), length = sqrt(square), per_square = Real(1) / square;
  const hinge::TurnGradient<Real> turn_a(a, c, length), turn_b(b, c, length);
  aa = -turn_a.by_arm;
  bb = turn_b.by_arm;
  ac = -turn_a.by_axis;
  bc = turn_b.by_axis;
  // gc = −α ga − β gb with α = a·c/|c|², β = b·c/|c|²
  const Real alpha = a.dot(c) * per_square, beta = b.dot(c) * per_square;
  const Vector alpha_by_c = per_square * (a - Real(2) * alpha * c), beta_by_c = per_square * (b - Real(2) * beta * c);
  cc = hinge::turn(a, c, length) * alpha_by_c.transpose() - hinge::turn(b, c, length) * beta_by_c.transpose() -
       alpha * ac - beta * bc;
}

}  // namespace sundrape

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
struct HingeAngle {
  double angle;
  Vector3 ga, gb, gc;  // ∂φ/∂a, ∂φ/∂b, ∂φ/∂c [1/m]

  HingeAngle(const Vector3& a, const Vector3& b, const Vector3& c);
};

/// The second derivatives that do not vanish (∂²φ/∂a∂b = 0) [1/m²]; ac is ∂²φ/∂a∂c with rows for a.
struct HingeCurvature {
  Matrix3 aa, bb, ac, bc, cc;

  HingeCurvature(const Vector3& a, const Vector3& b, const Vector3& c);
};

namespace hinge {

/// Turning arm a about c by one radian changes φ by one, so ∂φ/∂(arm) = |c| (c×a)/|c×a|², negative for the first arm.
inline Vector3 turn(const Vector3& arm, const Vector3& axis, double axis_length) {
  const Vector3 lever = axis.cross(arm);
  return axis_length / lever.squaredNorm() * lever;
}

/// Derivatives of `turn` by the arm and by the axis.
struct TurnGradient {
  Matrix3 by_arm, by_axis;

  TurnGradient(const Vector3& arm, const Vector3& axis, double axis_length) {
    const Vector3 lever = axis.cross(arm);
    const double square = lever.squaredNorm();
    const Vector3 scaled = lever / square;
    const Matrix3 by_lever = axis_length * (Matrix3::Identity() / square - 2 * scaled * scaled.transpose());
    by_arm = by_lever * cross_matrix(axis);
    by_axis = scaled * (axis / axis_length).transpose() - by_lever * cross_matrix(arm);
  }
};

}  // namespace hinge

inline HingeAngle::HingeAngle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double square = c.squaredNorm(), length = std::sqrt(square), per_square = 1 / square;
  const double ac = a.dot(c), bc = b.dot(c);
  angle = std::atan2(a.cross(b).dot(c), length * (a.dot(b) - ac * bc * per_square));
  ga = -hinge::turn(a, c, length);
  gb = hinge::turn(b, c, length);
  // φ does not change under a common rotation, nor with the length of c
  gc = (-ac * per_square) * ga - (bc * per_square) * gb;
}

inline HingeCurvature::HingeCurvature(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double square = c.squaredNorm(), length = std::sqrt(square);
  const hinge::TurnGradient turn_a(a, c, length), turn_b(b, c, length);
  aa = -turn_a.by_arm;
  bb = turn_b.by_arm;
  ac = -turn_a.by_axis;
  bc = turn_b.by_axis;
  // gc = −α ga − β gb with α = a·c/|c|², β = b·c/|c|²
  const double alpha = a.dot(c) / square, beta = b.dot(c) / square;
  const Vector3 alpha_by_c = (a - 2 * alpha * c) / square, beta_by_c = (b - 2 * beta * c) / square;
  cc = hinge::turn(a, c, length) * alpha_by_c.transpose() - hinge::turn(b, c, length) * beta_by_c.transpose() -
       alpha * ac - beta * bc;
}

}  // namespace sundrape

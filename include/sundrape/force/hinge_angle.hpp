#pragma once
#include "sundrape/types.hpp"

namespace sundrape {

/// The angle from edge a to edge b about an axis c, with its derivatives.
///
/// φ = atan2((a×b)·c, |c| a·b − (a·c)(b·c)/|c|): the turn of a thread about the thread that crosses it. Turning the
/// thread in the plane of a and c leaves φ alone, so it measures bending out of the sheet and no shear inside it; φ has
/// a sign, and it is smooth through a straight thread. All vectors in metres, φ in (−π, π).
struct HingeAngle {
  double angle;
  Vector3 ga, gb, gc;                   // ∂φ/∂a, ∂φ/∂b, ∂φ/∂c [1/m]

  HingeAngle(const Vector3& a, const Vector3& b, const Vector3& c);
};

/// The second derivatives that do not vanish (∂²φ/∂a∂b = 0) [1/m²]; ac is ∂²φ/∂a∂c with rows for a.
struct HingeCurvature {
  Matrix3 aa, bb, ac, bc, cc;

  HingeCurvature(const Vector3& a, const Vector3& b, const Vector3& c);
};

}  // namespace sundrape

#pragma once
#include <Eigen/Geometry>

#include "sundrape/types.hpp"

namespace sundrape {

/// A rotation, then a translation: x ↦ R x + t.
struct RigidPlacement {
  Matrix3 rotation = Matrix3::Identity();  // R
  Vector3 translation = Vector3::Zero();   // t [m]

  [[nodiscard]] Vector3 operator()(const Vector3& x) const { return rotation * x + translation; }
  [[nodiscard]] Vector3 inverse(const Vector3& x) const { return rotation.transpose() * (x - translation); }
};

/// How fast a rigid body moves: a point that is at x now has the rate  v + ω × x.
struct RigidRate {
  Vector3 spin = Vector3::Zero();      // ω [1/s]
  Vector3 velocity = Vector3::Zero();  // v, of the body's point at the origin [m/s]

  [[nodiscard]] Vector3 operator()(const Vector3& x) const { return velocity + spin.cross(x); }
};

inline RigidRate operator*(double factor, const RigidRate& rate) {
  return {factor * rate.spin, factor * rate.velocity};
}
inline RigidRate operator+(const RigidRate& a, const RigidRate& b) {
  return {a.spin + b.spin, a.velocity + b.velocity};
}

/// `second` after `first`.
[[nodiscard]] inline RigidPlacement operator*(const RigidPlacement& second, const RigidPlacement& first) {
  return {second.rotation * first.rotation, second(first.translation)};
}

/// The rate of a body in another frame, x ↦ R x + t: what it does there.
[[nodiscard]] inline RigidRate seen_from(const RigidPlacement& frame, const RigidRate& rate) {
  const Vector3 spin = frame.rotation * rate.spin;
  return {spin, frame.rotation * rate.velocity - spin.cross(frame.translation)};
}

}  // namespace sundrape

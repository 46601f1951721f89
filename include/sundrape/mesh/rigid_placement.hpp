#pragma once
#include "sundrape/types.hpp"

namespace sundrape {

/// A rotation, then a translation: x ↦ R x + t.
struct RigidPlacement {
  Matrix3 rotation = Matrix3::Identity();  // R
  Vector3 translation = Vector3::Zero();   // t [m]

  [[nodiscard]] Vector3 operator()(const Vector3& x) const { return rotation * x + translation; }
};

}  // namespace sundrape

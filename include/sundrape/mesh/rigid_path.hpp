#pragma once
#include <variant>

#include "sundrape/types.hpp"

namespace sundrape {

/// A turn about an axis through a centre; positive angles follow the right hand.
struct ArcPath {
  Vector3 centre = Vector3::Zero(), axis = Vector3::UnitZ();  // [m]; axis of unit length
  double angle = 0;                                           // [rad]
};

/// A straight translation [m].
struct LinePath {
  Vector3 by = Vector3::Zero();
};

/// How a rigid body is carried, from its place at a share of 0 to its end at 1.
using RigidPath = std::variant<ArcPath, LinePath>;

/// Where a point x [m] has got to after a share of the path, which may be outside [0, 1].
[[nodiscard]] Vector3 carried_along(const RigidPath& path, double share, const Vector3& x);

}  // namespace sundrape

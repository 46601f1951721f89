#pragma once
#include <variant>

#include "sundrape/mesh/keyframes.hpp"
#include "sundrape/mesh/rigid_placement.hpp"

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

/// Turns about an axis through a centre, then translations, both by keyframes: rows x, y, z of the translation [m],
/// then the angle [rad]. A share counts over the time from the first to the last.
struct KeyframePath {
  Keyframes keyframes;
  Vector3 centre = Vector3::Zero(), axis = Vector3::UnitZ();
};

/// How a rigid body is carried, from its place at a share of 0 to its end at 1.
using RigidPath = std::variant<ArcPath, LinePath, KeyframePath>;

/// Where a body that is at rest in x ↦ x has got to after a share of the path, which may be outside [0, 1].
[[nodiscard]] RigidPlacement placement_along(const RigidPath& path, double share);
/// Its rate by the share: of a point that is at x then, ∂x/∂share.
[[nodiscard]] RigidRate rate_along(const RigidPath& path, double share);

}  // namespace sundrape

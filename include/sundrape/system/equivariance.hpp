#pragma once
#include <span>
#include <vector>

#include "sundrape/system/point_map.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape {

/// A time at which all ramps and paths are over [s].
inline constexpr double after_everything = 1e9;

/// Largest |f(g q) − g f(q)| over |f(q)| of the forces of any one kind (membrane, bending, weight, contact, ...): 0 up
/// to round-off where the map is a symmetry of sheet, loads and obstacles, at this state.
///
/// Kinds are compared apart, since the membrane is a million times stiffer than weight is heavy. Damping and ramps do
/// not enter: at rest, with loads in full and obstacles at the ends of their paths. Infinite where forces are not
/// finite.
/// @param q  3P [m]
[[nodiscard]] double equivariance_defect(const System& system, const PointMap& map, const Vector& q);

/// Whether the supports are the same after the map: every held component goes to one that is held at the same value.
/// @param held  coordinates of the held points, 3P [m]
/// @param tolerance  of places [m]
[[nodiscard]] bool maps_supports(const Unknowns& unknowns, const PointMap& map, const Vector& held, double tolerance);

}  // namespace sundrape

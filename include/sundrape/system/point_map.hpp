#pragma once
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// An isometry of space that takes each point of a system to the place of another one.
///
/// Points 0 … places − 1 are places, x ↦ R (x − c) + c; the others are directions (directors of a shell), d ↦ s R d,
/// where s = −1 if the map turns the sheet's other side up.
struct PointMap {
  Matrix3 rotation = Matrix3::Identity();  // R, orthogonal
  Vector3 centre = Vector3::Zero();        // c [m]
  std::vector<int> image;                  // π over all points, P: point i takes the place of point π(i)
  int places = 0;
  double side = 1;  // s

  /// A state as it looks after the map, (g q)_π(i) = R (q_i − c) + c; 3P [m].
  [[nodiscard]] Vector move(const ConstVectorRef& q) const;
  /// Forces, rates or shifts after it, (g f)_π(i) = R f_i, s R f_i of directions; 3P.
  [[nodiscard]] Vector turn(const ConstVectorRef& f) const;
};

}  // namespace sundrape

#pragma once
#include <utility>
#include <vector>

namespace sundrape {

/// A circular arch in the x–z plane, hinged at both ends, with a force at its crown: an extensible beam whose curvature
/// at rest is 1/R, under rotations of any size. Half of it, by symmetry; its other equilibria are left out.
///
/// s runs along the arch at rest from a hinge (0) to the crown (R β), θ is the slope, ε the strain. With a force (H, V)
/// that the hinge exerts and the moment M, positive if it raises θ',
///     N = −(H cos θ + V sin θ),   ε = N/EA,   θ' = −1/R + M/EI,
///     M' = (1 + ε)(V cos θ − H sin θ),   x' = (1 + ε) cos θ,   z' = (1 + ε) sin θ,
/// M(0) = 0, and at the crown θ = 0, x = R sin β and z as prescribed; the load is 2 V.
struct PinnedArch {
  double radius = 1, half_angle = 0.1;  // R [m], β [rad]
  double stretching = 1, bending = 1;   // E A [N], E I [N m²]

  /// The downward force [N] that holds the crown at each of the heights [m], which go down from the one at rest in
  /// steps small enough for Newton's method.
  /// @throws std::runtime_error  where Newton's method fails
  [[nodiscard]] std::vector<double> forces(const std::vector<double>& heights, int steps = 400) const;
  /// Height of the crown at rest over the hinges [m].
  [[nodiscard]] double rise() const;
  /// The largest force on the way down and the smallest after it [N].
  [[nodiscard]] std::pair<double, double> limits() const;
};

}  // namespace sundrape

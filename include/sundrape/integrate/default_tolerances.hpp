#pragma once
#include <algorithm>
#include <cmath>

namespace sundrape {

/// Absolute tolerances where a case gives none (docs/integrators.md).
struct AbsoluteTolerances {
  double position;  // [m]
  double velocity;  // [m/s]
};

/// A quarter of rtol of the sheet's size, and 100 rtol √(g L), at most 0.01 √(g L): looser velocities cost more
/// failures than they save steps.
/// @param size     longest side of the sheet [m]
/// @param gravity  [m/s²]
[[nodiscard]] inline AbsoluteTolerances default_tolerances(double rtol, double size, double gravity) {
  return {0.25 * rtol * size, std::min(0.01, 100 * rtol) * std::sqrt(gravity * size)};
}

}  // namespace sundrape

#pragma once

namespace sundrape {

/// 0 to 1 between x = 0 and 1 with two continuous derivatives: x³ (10 − 15 x + 6 x²).
inline double smooth_step(double x) {
  if (x >= 1) return 1;
  if (x <= 0) return 0;
  return x * x * x * (10 + x * (6 * x - 15));
}

/// Its derivative.
inline double smooth_step_rate(double x) { return x <= 0 || x >= 1 ? 0.0 : 30 * x * x * (1 - x) * (1 - x); }

}  // namespace sundrape

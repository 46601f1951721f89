#pragma once

namespace sundrape {

/// How much of a load acts at a time: a C² rise from 0 to 1 over `duration` [s]; 1 from the start where it is 0.
struct Ramp {
  double duration = 0;

  [[nodiscard]] double at(double time) const {
    if (time >= duration) return 1;
    if (time <= 0) return 0;
    const double x = time / duration;
    return x * x * x * (10 + x * (6 * x - 15));
  }
};

}  // namespace sundrape

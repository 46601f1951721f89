#include "sundrape/force/friction_law.hpp"

#include <stdexcept>

namespace sundrape {

FrictionLaw::FrictionLaw(double speed) : speed_(speed) {
  if (!(speed > 0)) throw std::invalid_argument("the speed of creep of friction must be positive [m/s]");
}

double FrictionLaw::over_speed(double s) const {
  const double x = s / speed_;
  return x < 1 ? (3 - x * (3 - x)) / speed_ : 1 / s;
}

double FrictionLaw::slope_over_speed(double s) const {
  const double x = s / speed_;
  if (x >= 1) return -1 / (s * s * s);
  return x > 0 ? (2 * x - 3) / (speed_ * speed_ * s) : 0.0;
}

}  // namespace sundrape

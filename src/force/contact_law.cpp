#include "sundrape/force/contact_law.hpp"

#include <stdexcept>

namespace sundrape {

ContactLaw::ContactLaw(double stiffness, double smoothing) : stiffness_(stiffness), smoothing_(smoothing) {
  if (!(stiffness > 0)) throw std::invalid_argument("contact stiffness must be positive [N/m³]");
  if (!(smoothing > 0)) throw std::invalid_argument("contact smoothing must be positive [m]");
}

double ContactLaw::pressure(double gap) const {
  const double depth = smoothing_ - gap, x = depth / smoothing_;
  if (depth <= 0) return 0;
  if (x >= 1) return stiffness_ * (depth - 0.5 * smoothing_);
  return stiffness_ * smoothing_ * x * x * x * (1 - 0.5 * x);
}

double ContactLaw::energy(double gap) const {
  const double depth = smoothing_ - gap, x = depth / smoothing_;
  if (depth <= 0) return 0;
  const double past_middle = x - 0.5;
  const double scaled = x >= 1 ? 0.5 * past_middle * past_middle + 0.025 : x * x * x * x * (0.25 - 0.1 * x);
  return stiffness_ * smoothing_ * smoothing_ * scaled;
}

double ContactLaw::slope(double gap) const {
  const double depth = smoothing_ - gap, x = depth / smoothing_;
  if (depth <= 0) return 0;
  return x >= 1 ? stiffness_ : stiffness_ * x * x * (3 - 2 * x);
}

double ContactLaw::gap_under(double pressure) const {
  const double scaled = pressure / (stiffness_ * smoothing_);  // x³ − x⁴/2, or x − ½ from x = 1 on
  if (scaled >= 0.5) return smoothing_ * (0.5 - scaled);
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    (x * x * x * (1 - 0.5 * x) < scaled ? low : high) = x;
  }
  return smoothing_ * (1 - 0.5 * (low + high));
}

double suggested_stiffness(const ContactLoad& load, double penetration) {
  if (!(load.weight_per_area > 0 && load.diagonal > 0 && load.spread > 0 && penetration > 0))
    throw std::invalid_argument("contact stiffness needs a positive weight, size, cell and penetration");
  constexpr double landing = 64;
  return landing * load.weight_per_area * (load.diagonal / load.spread) / penetration;
}

}  // namespace sundrape

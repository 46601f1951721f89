#include "sundrape/integrate/stability_limit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "sundrape/system/largest_eigenvalue.hpp"

namespace sundrape {
namespace {

bool stable(std::complex<double> z) {
  return std::abs(1.0 + z * (1.0 + z * (0.5 + z * (1.0 / 6 + z / 24.0)))) <= 1 + 1e-12;
}

}  // namespace

double rk4_stable_step(double angular_frequency, double damping_rate) {
  const double half = 0.5 * damping_rate;
  const auto root = std::sqrt(std::complex<double>(half * half - angular_frequency * angular_frequency, 0));
  const std::complex<double> fast = -half - root, slow = -half + root;
  const double size = std::max(std::abs(fast), std::abs(slow));
  if (size == 0) return std::numeric_limits<double>::infinity();
  const auto both_stable = [&](double h) { return stable(h * fast) && stable(h * slow); };
  double low = 0, high = 4 / size;  // |z| = 4 lies outside the stability region
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (both_stable(middle) ? low : high) = middle;
  }
  return low;
}

StabilityLimit rk4_stability_limit(const System& system, const State& all, const ContactRates& contact) {
  const auto largest = [&](double dq, double dv) {
    return std::max(0.0, largest_eigenvalue(system, all, dq, dv, system.row_mass()));
  };
  StabilityLimit limit;
  limit.angular_frequency = std::sqrt(largest(-1, 0) + contact.angular_frequency * contact.angular_frequency);
  limit.damping_rate = largest(0, -1) + contact.damping_rate;
  limit.step = rk4_stable_step(limit.angular_frequency, limit.damping_rate);
  return limit;
}

}  // namespace sundrape

#include "support/planar_elastica.hpp"

#include <cmath>
#include <functional>
#include <stdexcept>

namespace sundrape {
namespace {

/// The law the other way round, K = f⁻¹(M): Newton's method kept between bounds, as f grows.
double curvature_under(double moment, const MomentCurvature& law) {
  const double wanted = std::abs(moment);
  double low = 0, high = wanted / law.initial_rigidity();
  while (law.at(high).moment < wanted) high *= 2;
  double curvature = high;
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const auto f = law.at(curvature);
    (f.moment < wanted ? low : high) = curvature;
    const double next = curvature - (f.moment - wanted) / f.slope;
    if (std::abs(next - curvature) <= 1e-15 * high) break;
    curvature = next > low && next < high ? next : 0.5 * (low + high);
  }
  return std::copysign(curvature, moment);
}

/// Slope, moment, and the way from here to the tip.
using Section = Eigen::Vector4d;

/// d/dσ of a section, σ = L − s being the distance from the tip.
Section change(const PlanarElastica& strip, double load_factor, double from_tip, const Section& at) {
  const double c = std::cos(at[0]), s = std::sin(at[0]);
  const Eigen::Vector2d pull = load_factor * (strip.tip_force - Eigen::Vector2d(0, strip.weight * from_tip));
  return {-curvature_under(at[1], strip.law), c * pull.y() - s * pull.x(), c, s};
}

/// The clamped end of a strip whose tip has this slope.
Section root(const PlanarElastica& strip, double load_factor, double tip_angle, int steps) {
  const double h = strip.length / steps;
  Section y(tip_angle, 0, 0, 0);
  for (int i = 0; i < steps; ++i) {
    const double from_tip = i * h;
    const auto slope = [&](double after, const Section& at) {
      return change(strip, load_factor, from_tip + after, at);
    };
    const Section k1 = slope(0, y), k2 = slope(0.5 * h, y + 0.5 * h * k1), k3 = slope(0.5 * h, y + 0.5 * h * k2),
                  k4 = slope(h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return y;
}

/// The zero of a function near `x`, by Newton's method with steps that are cut until they help.
double zero(const std::function<double(double)>& f, double x) {
  constexpr double difference = 1e-5, tolerance = 1e-13;
  double value = f(x);
  for (int iteration = 0; iteration < 100; ++iteration) {
    double move = -2 * difference * value / (f(x + difference) - f(x - difference));
    if (std::abs(move) <= tolerance) return x + move;
    double next = f(x + move);
    while (!(std::abs(next) < std::abs(value)) && std::abs(move) > tolerance) next = f(x + (move *= 0.5));
    x += move;
    value = next;
  }
  throw std::runtime_error("no equilibrium of the elastica next to the last one");
}

/// The slope of the tip at full load.
double tip_angle(const PlanarElastica& strip, int steps) {
  constexpr int load_steps = 20;
  double angle = strip.clamp_angle;
  for (int load = 1; load <= load_steps; ++load)
    angle = zero(
        [&](double tip) {
          return root(strip, static_cast<double>(load) / load_steps, tip, steps)[0] - strip.clamp_angle;
        },
        angle);
  return angle;
}

PlanarElastica::Shape shape(const PlanarElastica& strip, int steps) {
  const double angle = tip_angle(strip, steps);
  const Section clamp = root(strip, 1, angle, steps);
  return {.tip = clamp.tail<2>(),
          .tip_angle = angle,
          .root_moment = clamp[1],
          .root_curvature = curvature_under(clamp[1], strip.law)};
}

}  // namespace

PlanarElastica::Shape PlanarElastica::solve(int steps) const {
  Shape fine = shape(*this, steps);
  fine.error = (fine.tip - shape(*this, steps / 2).tip).norm();
  return fine;
}

}  // namespace sundrape

#include "sundrape/integrate/impact.hpp"

#include <stdexcept>

namespace sundrape {

Impact::Impact(const ObstacleContact& contact, Vector mass, double restitution, double smallest_speed)
    : contact_(contact),
      mass_(std::move(mass)),
      restitution_(restitution),
      smallest_speed_(smallest_speed),
      carried_(static_cast<std::size_t>(mass_.size()), false) {
  if (!(restitution >= 0 && restitution <= 1))
    throw std::invalid_argument("the coefficient of restitution must lie in [0, 1]");
  if (!(smallest_speed > 0)) throw std::invalid_argument("the smallest speed of an impact must be positive [m/s]");
}

double Impact::distance_to_reach(const State& all, int node) const {
  return contact_.closest(all, point(all.q, node)).gap - contact_.law().smoothing();
}

void Impact::evaluate(const State& all, std::span<double> values) const {
  for (int i = 0; i < count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    values[k] = carried_[k] ? 1.0 : distance_to_reach(all, i);
  }
}

bool Impact::happen(double time, ConstVectorRef q, VectorRef v, std::span<const int> fired) {
  bool changed = false;
  for (int i = 0; i < count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (fired[k] == 0) continue;
    const Vector3 normal = contact_.closest({time, q, v}, point(q, i)).normal;
    const double speed = normal.dot(point(v, i));
    if (speed > -smallest_speed_) {
      carried_[k] = true;
      continue;
    }
    point(v, i) -= (1 + restitution_) * speed * normal;
    dissipated_ += 0.5 * mass_[i] * (1 - restitution_ * restitution_) * speed * speed;
    changed = true;
  }
  return changed;
}

void Impact::accepted(const State& all) {
  for (int i = 0; i < count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (carried_[k] && distance_to_reach(all, i) > contact_.law().smoothing()) carried_[k] = false;
  }
}

}  // namespace sundrape

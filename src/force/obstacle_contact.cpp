#include "sundrape/force/obstacle_contact.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace sundrape {

ObstacleContact::ObstacleContact(std::vector<std::shared_ptr<const Obstacle>> obstacles, std::vector<double> areas,
                                 ContactLaw law)
    : areas_(std::move(areas)), law_(law) {
  for (auto& obstacle : obstacles) {
    if (!obstacle) throw std::invalid_argument("an obstacle is missing");
    auto reach = obstacle->bounds();
    const Vector3 margin = Vector3::Constant(law_.smoothing());
    bodies_.push_back({std::move(obstacle), {reach.min() - margin, reach.max() + margin}});
  }
  if (std::ranges::any_of(areas_, [](double area) { return !(area >= 0); }))
    throw std::invalid_argument("a tributary area must not be negative");
}

template <class Visit>
void ObstacleContact::visit_pairs(const State& state, Visit&& visit) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto& [obstacle, reach] = bodies_[b];
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      const Vector3 x = point(state.q, static_cast<int>(i));
      if (!reach.contains(x)) continue;
      const auto distance = obstacle->distance(x);
      if (distance.gap < law_.smoothing()) visit(i, b, distance);
    }
  }
}

double ObstacleContact::energy(const State& state) const {
  double sum = 0;
  visit_pairs(state, [&](std::size_t i, std::size_t, const Distance& d) { sum += areas_[i] * law_.energy(d.gap); });
  return sum;
}

void ObstacleContact::add_force(const State& state, VectorRef force) const {
  visit_pairs(state, [&](std::size_t i, std::size_t, const Distance& d) {
    point(force, static_cast<int>(i)) += areas_[i] * law_.pressure(d.gap) * d.normal;
  });
}

void ObstacleContact::add_tangent(const State& state, double dq, double /*dv: no rate dependence*/,
                                  Assembler& tangent) const {
  visit_pairs(state, [&](std::size_t i, std::size_t, const Distance& d) {
    const Matrix3 across = law_.slope(d.gap) * d.normal * d.normal.transpose();
    tangent.add_diagonal(i, 0, dq * areas_[i] * (law_.pressure(d.gap) * d.curvature - across));
  });
}

void ObstacleContact::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(1);
  for (int i = 0; i < static_cast<int>(areas_.size()); ++i) pattern.add_element(std::array{i});
}

ContactReport ObstacleContact::report(const State& state) const {
  ContactReport report;
  report.total_forces.assign(bodies_.size(), Vector3::Zero());
  visit_pairs(state, [&](std::size_t i, std::size_t b, const Distance& d) {
    ++report.contacts;
    report.deepest_penetration = std::max(report.deepest_penetration, -d.gap);
    report.total_forces[b] += areas_[i] * law_.pressure(d.gap) * d.normal;
  });
  return report;
}

std::pair<double, Vector3> ObstacleContact::closest(const Vector3& x) const {
  std::pair<double, Vector3> nearest{std::numeric_limits<double>::infinity(), Vector3::Zero()};
  for (const auto& body : bodies_) {
    const auto d = body.obstacle->distance(x);
    if (d.gap < nearest.first) nearest = {d.gap, d.normal};
  }
  return nearest;
}

}  // namespace sundrape

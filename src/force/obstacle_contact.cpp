#include "sundrape/force/obstacle_contact.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace sundrape {

ObstacleContact::ObstacleContact(std::vector<std::shared_ptr<const Obstacle>> obstacles,
                                 std::vector<ContactPoint> points, ContactLaw law)
    : points_(std::move(points)), law_(law) {
  for (auto& obstacle : obstacles) {
    if (!obstacle) throw std::invalid_argument("an obstacle is missing");
    auto reach = obstacle->bounds();
    const Vector3 margin = Vector3::Constant(law_.smoothing());
    bodies_.push_back({std::move(obstacle), {reach.min() - margin, reach.max() + margin}});
  }
  if (std::ranges::any_of(points_, [](const ContactPoint& p) { return !(p.area >= 0); }))
    throw std::invalid_argument("a tributary area must not be negative");
}

template <class Visit>
void ObstacleContact::visit_pairs(const State& state, Visit&& visit) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto& [obstacle, reach] = bodies_[b];
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector3 x = points_[i].position(state.q);
      if (!reach.contains(x)) continue;
      const auto distance = obstacle->distance(x);
      if (distance.gap < law_.smoothing()) visit(i, b, distance);
    }
  }
}

double ObstacleContact::energy(const State& state) const {
  double sum = 0;
  visit_pairs(state,
              [&](std::size_t i, std::size_t, const Distance& d) { sum += points_[i].area * law_.energy(d.gap); });
  return sum;
}

void ObstacleContact::add_force(const State& state, VectorRef force) const {
  visit_pairs(state, [&](std::size_t i, std::size_t, const Distance& d) {
    const auto& at = points_[i];
    const Vector3 push = at.area * law_.pressure(d.gap) * d.normal;
    for (std::size_t k = 0; k < 4 && at.nodes[k] >= 0; ++k) point(force, at.nodes[k]) += at.weights[k] * push;
  });
}

void ObstacleContact::add_tangent(const State& state, double dq, double /*dv: no rate dependence*/,
                                  Assembler& tangent) const {
  visit_pairs(state, [&](std::size_t i, std::size_t, const Distance& d) {
    const auto& at = points_[i];
    const Matrix3 whole =
        dq * at.area * (law_.pressure(d.gap) * d.curvature - law_.slope(d.gap) * d.normal * d.normal.transpose());
    for (int k = 0; k < 4 && at.nodes[static_cast<std::size_t>(k)] >= 0; ++k) {
      const double weight = at.weights[static_cast<std::size_t>(k)];
      tangent.add_diagonal(i, k, weight * weight * whole);
      for (int j = 0; j < k; ++j) tangent.add_pair(i, j, k, at.weights[static_cast<std::size_t>(j)] * weight * whole);
    }
  });
}

void ObstacleContact::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (const auto& at : points_) pattern.add_element(at.nodes);
}

ContactReport ObstacleContact::report(const State& state) const {
  ContactReport report;
  report.total_forces.assign(bodies_.size(), Vector3::Zero());
  visit_pairs(state, [&](std::size_t i, std::size_t b, const Distance& d) {
    ++report.contacts;
    report.deepest_penetration = std::max(report.deepest_penetration, -d.gap);
    report.total_forces[b] += points_[i].area * law_.pressure(d.gap) * d.normal;
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

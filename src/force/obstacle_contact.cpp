#include "sundrape/force/obstacle_contact.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace sundrape {
namespace {

Vector3 along_surface(const Vector3& v, const Vector3& normal) { return v - v.dot(normal) * normal; }

/// Of a body that stands at a place from a point as seen from there.
Distance distance_to(const ContactBody& body, const RigidPlacement& at, const Vector3& seen) {
  const auto d = body.obstacle->distance(seen);
  return body.course ? turned(d, at.rotation) : d;
}

}  // namespace

ObstacleContact::ObstacleContact(std::vector<ContactBody> bodies, std::vector<ContactPoint> points, ContactLaw law,
                                 FrictionLaw friction, FrictionMatrix matrix)
    : bodies_(std::move(bodies)),
      points_(std::move(points)),
      law_(law),
      friction_law_(friction),
      friction_matrix_(matrix) {
  for (const auto& body : bodies_) {
    if (!body.obstacle) throw std::invalid_argument("an obstacle is missing");
    if (!(body.friction >= 0)) throw std::invalid_argument("a coefficient of friction must not be negative");
    const auto bounds = body.obstacle->bounds();
    const Vector3 margin = Vector3::Constant(law_.smoothing());
    reach_.emplace_back(bounds.min() - margin, bounds.max() + margin);
  }
  if (std::ranges::any_of(points_, [](const ContactPoint& p) { return !(p.area >= 0); }))
    throw std::invalid_argument("a tributary area must not be negative");
}

double ObstacleContact::largest_friction() const {
  double largest = 0;
  for (const auto& body : bodies_) largest = std::max(largest, body.friction);
  return largest;
}

RigidPlacement ObstacleContact::carried(std::size_t body, const State& when) const {
  const auto& course = bodies_[body].course;
  return course ? course->placement(when) : RigidPlacement{};
}

template <class Visit>
void ObstacleContact::visit_pairs(const State& state, Visit&& visit) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto& body = bodies_[b];
    const auto at = carried(b, state);
    const auto motion = body.course ? body.course->rate(state) : RigidRate{};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector3 x = points_[i].position(state.q);
      const Vector3 seen = body.course ? at.inverse(x) : x;
      if (!reach_[b].contains(seen)) continue;
      const auto distance = distance_to(body, at, seen);
      if (!(distance.gap < law_.smoothing())) continue;
      const double length = distance.normal.norm();
      const Vector3 unit = length > 0 ? Vector3(distance.normal / length) : Vector3(Vector3::Zero());
      visit(Pair{i, b, distance, unit, x, points_[i].area * law_.pressure(distance.gap), motion});
    }
  }
}

Vector3 ObstacleContact::relative(const Pair& pair, const State& state) const {
  return points_[pair.point].position(state.v) - pair.motion(pair.position);
}

Vector3 ObstacleContact::sliding(const Pair& pair, const State& state) const {
  return along_surface(relative(pair, state), pair.normal);
}

Vector3 ObstacleContact::friction(const Pair& pair, const State& state) const {
  const double coefficient = bodies_[pair.body].friction;
  if (coefficient == 0) return Vector3::Zero();
  const Vector3 v = sliding(pair, state);
  return -coefficient * pair.push * friction_law_.over_speed(v.norm()) * v;
}

Matrix3 ObstacleContact::friction_tangent(const Pair& pair, const State& state, double dq, double dv,
                                          bool whole) const {
  const auto& [gap, gradient, curvature] = pair.distance;
  const auto& n = pair.normal;
  const double largest = bodies_[pair.body].friction * pair.push;
  const Vector3 relative = this->relative(pair, state), v = along_surface(relative, n);
  const double s = v.norm(), over_speed = friction_law_.over_speed(s);
  const Matrix3 along = Matrix3::Identity() - n * n.transpose();
  Matrix3 by_sliding = -largest * over_speed * Matrix3::Identity();  // ∂f/∂v
  if (friction_matrix_ == FrictionMatrix::tangent)
    by_sliding -= largest * friction_law_.slope_over_speed(s) * v * v.transpose();
  Matrix3 tangent = dv * by_sliding * along;
  if (!whole) return tangent;
  // ∂v/∂x, since the surface turns below the point and may move itself
  const Matrix3 turn =
      -along * cross_matrix(pair.motion.spin) - n.dot(relative) * curvature - n * (curvature * relative).transpose();
  const double by_gap = bodies_[pair.body].friction * points_[pair.point].area * law_.slope(gap) * over_speed;
  return tangent + dq * (by_gap * v * gradient.transpose() + by_sliding * turn);
}

double ObstacleContact::energy(const State& state) const {
  double sum = 0;
  visit_pairs(state, [&](const Pair& pair) { sum += points_[pair.point].area * law_.energy(pair.distance.gap); });
  return sum;
}

double ObstacleContact::dissipated_power(const State& state) const {
  double sum = 0;
  visit_pairs(state, [&](const Pair& pair) { sum -= friction(pair, state).dot(sliding(pair, state)); });
  return sum;
}

double ObstacleContact::external_power(const State& state) const {
  if (std::ranges::none_of(bodies_, [](const ContactBody& body) { return body.course.has_value(); })) return 0;
  double sum = 0;
  visit_pairs(state, [&](const Pair& pair) {
    sum += (pair.push * pair.distance.normal + friction(pair, state)).dot(pair.motion(pair.position));
  });
  return sum;
}

void ObstacleContact::add_force(const State& state, VectorRef force) const {
  visit_pairs(state, [&](const Pair& pair) {
    const auto& at = points_[pair.point];
    const Vector3 push = pair.push * pair.distance.normal + friction(pair, state);
    for (std::size_t k = 0; k < 4 && at.nodes[k] >= 0; ++k) point(force, at.nodes[k]) += at.weights[k] * push;
  });
}

void ObstacleContact::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool keeps_unsymmetric = tangent.keeps_unsymmetric();
  visit_pairs(state, [&](const Pair& pair) {
    const auto& at = points_[pair.point];
    const auto& [gap, n, curvature] = pair.distance;
    Matrix3 whole = dq * (pair.push * curvature - at.area * law_.slope(gap) * n * n.transpose());
    const bool rough = bodies_[pair.body].friction > 0;
    if (rough) whole += friction_tangent(pair, state, dq, dv, keeps_unsymmetric);
    for (int k = 0; k < 4 && at.nodes[static_cast<std::size_t>(k)] >= 0; ++k) {
      const double weight = at.weights[static_cast<std::size_t>(k)];
      tangent.add_diagonal(pair.point, k, weight * weight * whole);
      for (int j = 0; j < k; ++j) {
        const Matrix3 block = at.weights[static_cast<std::size_t>(j)] * weight * whole;
        if (rough && keeps_unsymmetric)
          tangent.add_general_pair(pair.point, j, k, block, block);
        else
          tangent.add_pair(pair.point, j, k, block);
      }
    }
  });
}

void ObstacleContact::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (const auto& at : points_) pattern.add_element(at.nodes);
}

ContactReport ObstacleContact::report(const State& state) const {
  ContactReport report;
  visit_pairs(state, [&](const Pair& pair) {
    ++report.contacts;
    report.deepest_penetration = std::max(report.deepest_penetration, -pair.distance.gap);
    if (bodies_[pair.body].friction > 0) report.count_friction(sliding(pair, state).norm(), friction_law_.speed());
  });
  return report;
}

std::vector<Vector3> ObstacleContact::total_forces(const State& state) const {
  std::vector<Vector3> forces(bodies_.size(), Vector3::Zero());
  visit_pairs(state,
              [&](const Pair& pair) { forces[pair.body] += pair.push * pair.distance.normal + friction(pair, state); });
  return forces;
}

ClosestSurface ObstacleContact::closest(const State& when, const Vector3& x) const {
  ClosestSurface nearest{std::numeric_limits<double>::infinity(), Vector3::Zero(), 0};
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto at = carried(b, when);
    const auto d = distance_to(bodies_[b], at, at.inverse(x));
    if (d.gap < nearest.gap) nearest = {d.gap, d.normal, b};
  }
  return nearest;
}

}  // namespace sundrape

#include "sundrape/force/cloth_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>

#include "cloth_friction.hpp"
#include "edge_crossing.hpp"
#include "swept_clearance.hpp"

namespace sundrape {
namespace {

// Candidates are searched with this margin at first and at least, as a part of the thickness, and at most as a part of
// a triangle's size; in between what lets them last for a while.
constexpr double least_margin = 0.5, largest_margin = 0.7;
constexpr long short_life = 20, long_life = 400;  // uses
// Pairs that are this part of the thickness from pressing couple: what slides meets new ones now and then only. Edges
// are a second line, and mostly idle.
constexpr double coupled_beyond = 0.5, coupled_beyond_edges = 0.25;
// Nodes keep at least this part of the thickness from what they are about to pass through: the barrier of the law never
// lets them come so near.
constexpr double least_clearance = 0.02;
// Within the barrier Newton's last correction changes distances by this part of them at most: Newton's iteration comes
// out of it by a third of the distance at a time, and leaves an error of some 3 % of the force there.
constexpr double settled = 0.1;

/// How far nodes are from where they were, less what all have in common: it does not bring them nearer to each other.
/// Two of them have come nearer by twice that, at most.
double largest_own_move(const ConstVectorRef& from, const ConstVectorRef& to, int nodes) {
  Eigen::AlignedBox3d moves;
  for (int i = 0; i < nodes; ++i) moves.extend(Vector3(point(to, i) - point(from, i)));
  const Vector3 common = moves.center();
  double most = 0;
  for (int i = 0; i < nodes; ++i) most = std::max(most, (point(to, i) - point(from, i) - common).squaredNorm());
  return std::sqrt(most);
}

Vector3 mean_place(const std::array<Vector3, 4>& x, const std::array<double, 4>& weights) {
  Vector3 place = Vector3::Zero();  // the middle of the way between the nearest points
  for (std::size_t k = 0; k < 4; ++k) place += 0.5 * std::abs(weights[k]) * x[k];
  return place;
}

std::string passage_text(const ClothPair& pair) {
  const auto& p = pair.points;
  const auto name = [&](std::size_t k) { return std::to_string(p[k]); };
  if (pair.shapes == Shapes::edge_edge)
    return "the edge of nodes " + name(0) + " and " + name(1) + " through that of nodes " + name(2) + " and " + name(3);
  return "node " + name(0) + " through the triangle of nodes " + name(1) + ", " + name(2) + " and " + name(3);
}

}  // namespace

/// A pair that presses.
struct ClothContact::Contact {
  const ClothPair& pair;
  std::int32_t element;
  std::array<Vector3, 4> x;
  Separation separation;
  Vector3 normal;         // unit vector along the way
  EdgeCrossing crossing;  // 1 but for edges
  double push;            // A p, less of edges that are nearly parallel [N]
};

ClothContact::ClothContact(ClothPairs pairs, const ContactLaw& law, ClothContactOptions options)
    : pairs_(std::move(pairs)), law_(law), options_(options), margin_(least_margin * pairs_.largest_thickness()) {
  for (const auto& edge : surface().edges) mean_edge_ += edge.length / static_cast<double>(surface().edges.size());
  if (!(pairs_.smallest_thickness() > law_.smoothing()))
    throw std::invalid_argument("cloth must be thicker than the distance over which contact sets in");
  if (!(options_.friction >= 0)) throw std::invalid_argument("a coefficient of friction must not be negative");
}

double ClothContact::moved_since_search(const ConstVectorRef& q) const {
  if (searched_at_.size() == 0) return std::numeric_limits<double>::infinity();
  return largest_own_move(searched_at_, q, surface().nodes());
}

void ClothContact::search(const ConstVectorRef& q, double margin) const {
  const auto nodes = 3 * static_cast<Eigen::Index>(surface().nodes());
  searched_at_ = q.head(nodes);
  margin_ = margin;
  uses_ = 0;
  ++searches_;
  candidates_.clear();
  if (!searched_at_.allFinite()) return;  // whoever asked will notice
  for (const auto& [pair, distance] : pairs_.within(reach() + margin, searched_at_))
    candidates_.push_back({pair, distance, -1});
  list_elements();
}

double ClothContact::require_candidates(const ConstVectorRef& q) const {
  ++uses_;
  const double moved = moved_since_search(q);
  if (moved <= 0.5 * margin_) return moved;
  double margin = margin_;
  if (searches_ > 0 && uses_ < short_life) margin *= 2;
  if (uses_ > long_life) margin *= 0.5;
  const double least = least_margin * pairs_.largest_thickness();
  search(q, std::clamp(margin, least, std::max(least, largest_margin * mean_edge_)));
  return 0;
}

/// Tells candidates which element they are.
void ClothContact::list_elements() const {
  const auto key = [](const ClothPair& pair) { return std::pair(pair.shapes, pair.points); };
  for (auto& candidate : candidates_) {
    const auto found = std::ranges::lower_bound(elements_, key(candidate.pair), {}, key);
    const bool listed = found != elements_.end() && key(*found) == key(candidate.pair);
    candidate.element = listed ? static_cast<std::int32_t>(found - elements_.begin()) : -1;
  }
}

bool ClothContact::couples(const ClothPair& pair, const ConstVectorRef& q) const {
  const double beyond = pair.shapes == Shapes::edge_edge ? coupled_beyond_edges : coupled_beyond;
  const double near = law_.reach(rest_distance(pair)) + beyond * pair.thickness;
  return separation(pair.shapes, pair.at(q)).distance < near;
}

bool ClothContact::adapt(const State& state) const {
  bool complete = true;
  visit(state, [&](const Contact& contact) { complete = complete && contact.element >= 0; });
  if (complete) return true;
  elements_.clear();
  for (const auto& candidate : candidates_)
    if (couples(candidate.pair, state.q)) elements_.push_back(candidate.pair);
  std::ranges::sort(elements_, {}, [](const ClothPair& pair) { return std::pair(pair.shapes, pair.points); });
  list_elements();
  ++patterns_;
  return false;
}

void ClothContact::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (const auto& pair : elements_) pattern.add_element(pair.points);
}

bool ClothContact::may_be_within(double near, const Candidate& candidate, const ConstVectorRef& q) const {
  const auto& points = candidate.pair.points;
  const std::size_t count = points_of(candidate.pair.shapes),
                    first = candidate.pair.shapes == Shapes::edge_edge ? 2 : 1;
  std::array<Vector3, 4> moved;
  for (std::size_t k = 0; k < count; ++k) moved[k] = point(q, points[k]) - point(searched_at_, points[k]);
  double most = 0;  // a way between the shapes changes by a mean of such differences
  for (std::size_t a = 0; a < first; ++a)
    for (std::size_t b = first; b < count; ++b) most = std::max(most, (moved[a] - moved[b]).squaredNorm());
  const double slack = candidate.distance - near;
  return slack <= 0 || most >= slack * slack;
}

template <class Visit>
void ClothContact::visit(const State& state, Visit&& visit) const {
  const double nearer = 2 * require_candidates(state.q);
  for (const auto& candidate : candidates_) {
    const auto& [pair, distance, element] = candidate;
    const double near = law_.reach(rest_distance(pair));
    if (distance - nearer > near || !may_be_within(near, candidate, state.q)) continue;
    const auto x = pair.at(state.q);
    const auto s = separation(pair.shapes, x);
    if (!(s.distance < near) || s.distance == 0) continue;
    const auto crossing = pair.shapes == Shapes::edge_edge ? EdgeCrossing(x, pair.parallel2) : EdgeCrossing();
    const double pressure = law_.pressure(s.distance, rest_distance(pair));
    visit(Contact{pair, element, x, s, s.way / s.distance, crossing, crossing.factor * pair.area * pressure});
  }
}

Vector3 ClothContact::sliding(const Contact& contact, const State& state) const {
  const auto& w = contact.separation.weights;
  Vector3 v = Vector3::Zero();
  for (std::size_t k = 0; k < points_of(contact.pair.shapes); ++k) v += w[k] * point(state.v, contact.pair.points[k]);
  return v - v.dot(contact.normal) * contact.normal;
}

double ClothContact::energy(const State& state) const {
  double sum = 0;
  visit(state, [&](const Contact& contact) {
    const auto& pair = contact.pair;
    sum += contact.crossing.factor * pair.area * law_.energy(contact.separation.distance, rest_distance(pair));
  });
  return sum;
}

double ClothContact::dissipated_power(const State& state) const {
  if (options_.friction == 0) return 0;
  double sum = 0;
  visit(state, [&](const Contact& contact) {
    const Vector3 v = sliding(contact, state);
    sum += options_.friction * contact.push * options_.friction_law.over_speed(v.norm()) * v.squaredNorm();
  });
  return sum;
}

void ClothContact::add_force(const State& state, VectorRef force) const {
  visit(state, [&](const Contact& contact) {
    const auto& pair = contact.pair;
    Vector3 push = contact.push * contact.normal;
    if (options_.friction > 0) {
      const Vector3 v = sliding(contact, state);
      push -= options_.friction * contact.push * options_.friction_law.over_speed(v.norm()) * v;
    }
    for (std::size_t k = 0; k < points_of(pair.shapes); ++k)
      point(force, pair.points[k]) += contact.separation.weights[k] * push;
    if (contact.crossing.is_constant()) return;
    for (std::size_t k = 0; k < 4; ++k)
      point(force, pair.points[k]) -=
          pair.area * law_.energy(contact.separation.distance, rest_distance(pair)) * contact.crossing.gradient[k];
  });
}

void ClothContact::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool whole = tangent.keeps_unsymmetric();
  visit(state, [&](const Contact& contact) {
    if (contact.element < 0) throw std::logic_error("cloth contact has not adapted to the state");
    const auto& pair = contact.pair;
    const auto& s = contact.separation;
    const auto& crossing = contact.crossing;
    const Vector3& n = contact.normal;
    const double push = contact.push;
    const double d = s.distance, rest = rest_distance(pair);
    const auto& w = s.weights;
    const std::size_t points = points_of(pair.shapes);
    const SeparationHessian turning(s, contact.x);
    const double bend = push / s.distance;                                          // of the distance's own curvature
    const double along = bend + crossing.factor * pair.area * law_.slope(d, rest);  // of n nᵀ
    const Matrix3 nn = n * n.transpose();
    const auto conservative = [&](std::size_t k, std::size_t l) -> Matrix3 {
      Matrix3 block = bend * turning.block(k, l) - along * w[k] * w[l] * nn;
      if (!crossing.is_constant()) {
        const double pressure = pair.area * law_.pressure(d, rest);
        block +=
            pressure * (w[k] * n * crossing.gradient[l].transpose() + w[l] * crossing.gradient[k] * n.transpose()) -
            pair.area * law_.energy(d, rest) * crossing.hessian(k, l);
      }
      return block;
    };
    std::optional<ClothFriction> friction;
    if (options_.friction > 0) {
      const auto v = pair.at(state.v);
      friction.emplace(s, n, v, options_.friction, push, options_.friction_law, options_.friction_matrix);
      if (whole)
        friction->prepare_by_place(contact.x, v, turning, crossing.factor * pair.area * law_.slope(d, rest),
                                   pair.area * law_.pressure(d, rest), crossing.gradient);
    }
    const auto e = static_cast<std::size_t>(contact.element);
    for (std::size_t k = 0; k < points; ++k)
      for (std::size_t l = 0; l <= k; ++l) {
        Matrix3 block = dq * conservative(l, k);
        if (friction) block += dv * friction->by_velocity(l, k);
        if (!friction || !whole) {
          if (k == l)
            tangent.add_diagonal(e, static_cast<int>(k), block);
          else
            tangent.add_pair(e, static_cast<int>(l), static_cast<int>(k), block);
          continue;
        }
        if (k == l) {
          tangent.add_diagonal(e, static_cast<int>(k), block + dq * friction->by_place(k, k));
        } else {
          const Matrix3 mirrored = dq * conservative(k, l) + dv * friction->by_velocity(k, l);
          tangent.add_general_pair(e, static_cast<int>(l), static_cast<int>(k), block + dq * friction->by_place(l, k),
                                   mirrored + dq * friction->by_place(k, l));
        }
      }
  });
}

std::optional<Passage> ClothContact::passage(const State& from, const State& to) const {
  // pairs that come near on the way are candidates at its start and at its end, or must be found now
  double moved = std::max(moved_since_search(from.q), moved_since_search(to.q));
  if (!(moved <= 0.5 * margin_)) {
    moved = largest_own_move(from.q, to.q, surface().nodes());
    search(from.q, std::max(margin_, 2 * moved));
  }
  const double clearance = least_clearance * pairs_.smallest_thickness(), nearer = 2 * moved;
  for (const auto& [pair, distance, element] : candidates_) {
    if (distance - nearer > clearance) continue;
    if (pair.shapes != Shapes::point_triangle && pair.shapes != Shapes::edge_edge) continue;
    if (const auto met = first_contact(pair.shapes, pair.at(from.q), pair.at(to.q), clearance))
      return Passage{passage_text(pair), mean_place(pair.at(from.q), met->weights)};
  }
  return std::nullopt;
}

bool ClothContact::settles(const State& before, const State& after) const {
  const double nearer = 2 * require_candidates(after.q);
  return std::ranges::all_of(candidates_, [&](const Candidate& candidate) {
    const auto& pair = candidate.pair;
    const double barrier = ClothLaw::barrier_begin(rest_distance(pair));
    if (candidate.distance - nearer > barrier || !may_be_within(barrier, candidate, after.q)) return true;
    const double distance = separation(pair.shapes, pair.at(after.q)).distance;
    if (distance >= barrier) return true;
    return std::abs(distance - separation(pair.shapes, pair.at(before.q)).distance) <= settled * distance;
  });
}

ContactReport ClothContact::report(const State& state) const {
  ContactReport report;
  visit(state, [&](const Contact& contact) {
    if (contact.pair.area < 0 || contact.pair.shapes == Shapes::point_point) return;  // corrections
    ++report.contacts;
    if (contact.pair.shapes == Shapes::point_triangle)
      report.deepest_penetration =
          std::max(report.deepest_penetration, contact.pair.thickness - contact.separation.distance);
    if (options_.friction > 0) report.count_friction(sliding(contact, state).norm(), options_.friction_law.speed());
  });
  return report;
}

}  // namespace sundrape

#include "sundrape/force/edge_moment.hpp"

#include <array>

#include "couple.hpp"

namespace sundrape {
namespace {

Vector3 edge(const LoadedEdge& l, ConstVectorRef x) { return point(x, l.end) - point(x, l.inner); }

}  // namespace

EdgeMoment::EdgeMoment(std::vector<LoadedEdge> edges, LoadCourse course)
    : edges_(std::move(edges)), course_(std::move(course)) {}

double EdgeMoment::external_power(const State& state) const {
  double power = 0;
  for (const auto& l : edges_) power += couple(l.moment, edge(l, state.q)).dot(edge(l, state.v));
  return course_.share(state) * power;
}

void EdgeMoment::add_force(const State& state, VectorRef f) const {
  const double share = course_.share(state);
  for (const auto& l : edges_) {
    const Vector3 force = share * couple(l.moment, edge(l, state.q));
    point(f, l.end) += force;
    point(f, l.inner) -= force;
  }
}

void EdgeMoment::add_tangent(const State& state, double dq, double /*dv*/, Assembler& tangent) const {
  const double share = dq * course_.share(state);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    Matrix3 by_edge = couple_by_arm(share * edges_[k].moment, edge(edges_[k], state.q));
    if (!tangent.keeps_unsymmetric()) by_edge = Matrix3(0.5 * (by_edge + by_edge.transpose()));
    tangent.add_diagonal(k, 0, by_edge);
    tangent.add_diagonal(k, 1, by_edge);
    tangent.add_general_pair(k, 0, 1, -by_edge, -by_edge);
  }
}

void EdgeMoment::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(2);
  for (const auto& l : edges_) pattern.add_element(std::array{l.inner, l.end});
}

}  // namespace sundrape

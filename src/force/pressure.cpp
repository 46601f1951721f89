#include "sundrape/force/pressure.hpp"

#include <Eigen/Geometry>

namespace sundrape {
namespace {

struct Diagonals {
  Vector3 first, second;
};

Diagonals diagonals(const std::array<int, 4>& n, ConstVectorRef x) {
  return {point(x, n[2]) - point(x, n[0]), point(x, n[3]) - point(x, n[1])};
}

}  // namespace

Pressure::Pressure(std::vector<std::array<int, 4>> faces, double pressure, LoadCourse course)
    : faces_(std::move(faces)), pressure_(pressure), course_(std::move(course)) {}

double Pressure::external_power(const State& state) const {
  double power = 0;
  for (const auto& face : faces_) {
    const auto d = diagonals(face, state.q);
    Vector3 velocity = Vector3::Zero();
    for (const int n : face) velocity += point(state.v, n);
    power += d.first.cross(d.second).dot(velocity) / 8;
  }
  return course_.share(state) * pressure_ * power;
}

void Pressure::add_force(const State& state, VectorRef f) const {
  const double share = course_.share(state) * pressure_ / 8;
  for (const auto& face : faces_) {
    const auto d = diagonals(face, state.q);
    const Vector3 force = share * d.first.cross(d.second);
    for (const int n : face) point(f, n) += force;
  }
}

void Pressure::add_tangent(const State& state, double dq, double /*dv*/, Assembler& tangent) const {
  const double share = dq * course_.share(state) * pressure_ / 8;
  for (std::size_t e = 0; e < faces_.size(); ++e) {
    const auto d = diagonals(faces_[e], state.q);
    const Matrix3 by_first = -share * cross_matrix(d.second), by_second = share * cross_matrix(d.first);
    // every node carries the same force, so block (p, q) depends on q alone: ∂f/∂x_q
    const std::array<Matrix3, 4> by_node{-by_first, -by_second, by_first, by_second};
    for (int q = 0; q < 4; ++q) {
      const auto& column = by_node[static_cast<std::size_t>(q)];
      if (tangent.keeps_unsymmetric()) tangent.add_diagonal(e, q, column);  // its symmetric part vanishes
      for (int p = 0; p < q; ++p) tangent.add_general_pair(e, p, q, column, by_node[static_cast<std::size_t>(p)]);
    }
  }
}

void Pressure::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (const auto& face : faces_) pattern.add_element(face);
}

}  // namespace sundrape

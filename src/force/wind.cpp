#include "sundrape/force/wind.hpp"

#include <cmath>
#include <stdexcept>

#include "face_load.hpp"

namespace sundrape {
namespace {

constexpr double along_face = 0.01;  // ε

}  // namespace

/// One face in the flow.
struct Wind::Face {
  FaceDiagonals diagonals;
  Vector3 area, u;           // a [m²], u [m/s]
  double size, s, speed, r;  // |a|, u·a, |u|
  Vector3 drag, lift;        // [N]

  Face(const std::array<int, 4>& nodes, const State& state) : diagonals(nodes, state.q), area(diagonals.area()) {}
};

Wind::Wind(std::vector<std::array<int, 4>> faces, WindField field, AirCoefficients air, LoadCourse course)
    : faces_(std::move(faces)), field_(std::move(field)), air_(air), course_(std::move(course)) {
  if (!(air_.density >= 0 && air_.drag >= 0 && air_.lift >= 0))
    throw std::invalid_argument("air has no negative density and no negative coefficients");
  if (!(field_.period > 0)) throw std::invalid_argument("gusts need a positive period [s]");
}

Wind::Face Wind::face(const std::array<int, 4>& n, const State& state, const Vector3& wind) const {
  Face f(n, state);
  f.u = wind - 0.25 * (point(state.v, n[0]) + point(state.v, n[1]) + point(state.v, n[2]) + point(state.v, n[3]));
  f.size = f.area.norm();
  f.s = f.u.dot(f.area);
  f.speed = f.u.norm();
  f.r = std::hypot(f.s, along_face * f.size * f.speed);
  const double half = 0.5 * air_.density;
  f.drag = half * air_.drag * f.r * f.u;
  f.lift = Vector3::Zero();
  if (f.size > 0 && f.speed > 0)
    f.lift = half * air_.lift / f.size * (f.s * f.speed * f.area - f.s * f.s / f.speed * f.u);
  return f;
}

double Wind::dissipated_power(const State& state) const {
  const Vector3 wind = field_.at(state.time);
  double power = 0;
  for (const auto& nodes : faces_) {
    const auto f = face(nodes, state, wind);
    power += f.drag.dot(f.u);
  }
  return course_.share(state) * power;
}

double Wind::external_power(const State& state) const {
  const Vector3 wind = field_.at(state.time);
  if (wind.isZero()) return 0;
  Vector3 force = Vector3::Zero();
  for (const auto& nodes : faces_) {
    const auto f = face(nodes, state, wind);
    force += f.drag + f.lift;
  }
  return course_.share(state) * force.dot(wind);
}

void Wind::add_force(const State& state, VectorRef f) const {
  const Vector3 wind = field_.at(state.time);
  const double share = 0.25 * course_.share(state);
  for (const auto& nodes : faces_) {
    const auto at = face(nodes, state, wind);
    for (const int n : nodes) point(f, n) += share * (at.drag + at.lift);
  }
}

void Wind::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const Vector3 wind = field_.at(state.time);
  const double share = 0.25 * course_.share(state), half = 0.5 * air_.density;
  for (std::size_t e = 0; e < faces_.size(); ++e) {
    const auto f = face(faces_[e], state, wind);
    if (!(f.size > 0 && f.speed > 0)) continue;
    const Vector3 &u = f.u, &a = f.area;
    const Vector3 along_u = u / f.speed, normal = a / f.size;
    const double e2 = along_face * along_face;
    // of r by u and by a
    const Vector3 r_u = (f.s * a + e2 * f.size * f.size * u) / f.r, r_a = (f.s * u + e2 * f.speed * f.speed * a) / f.r;
    Matrix3 by_u = half * air_.drag * (f.r * Matrix3::Identity() + u * r_u.transpose());
    Matrix3 by_a = half * air_.drag * u * r_a.transpose();
    const double lift = half * air_.lift;
    by_u += lift * (f.speed * normal * a.transpose() + f.s * normal * along_u.transpose() -
                    2 * f.s / (f.size * f.speed) * u * a.transpose() -
                    f.s * f.s / (f.size * f.speed) * (Matrix3::Identity() - along_u * along_u.transpose()));
    by_a += lift * (f.speed / f.size * a * u.transpose() +
                    f.s * f.speed / f.size * (Matrix3::Identity() - normal * normal.transpose()) -
                    2 * f.s / (f.size * f.speed) * u * u.transpose() +
                    f.s * f.s / (f.size * f.size * f.speed) * u * normal.transpose());
    const Matrix3 by_velocity = -0.25 * dv * share * by_u;
    const Matrix3 by_first = -0.5 * dq * share * by_a * cross_matrix(f.diagonals.second);
    const Matrix3 by_second = 0.5 * dq * share * by_a * cross_matrix(f.diagonals.first);
    auto by_node = by_nodes(by_first, by_second);
    for (auto& block : by_node) block += by_velocity;
    add_shared_tangent(by_node, e, tangent);
  }
}

void Wind::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (const auto& face : faces_) pattern.add_element(face);
}

}  // namespace sundrape

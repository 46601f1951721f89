#include "sundrape/force/pressure.hpp"

#include "face_load.hpp"

namespace sundrape {

Pressure::Pressure(std::vector<std::array<int, 4>> faces, double pressure, LoadCourse course)
    : faces_(std::move(faces)), pressure_(pressure), course_(std::move(course)) {}

double Pressure::external_power(const State& state) const {
  double power = 0;
  for (const auto& face : faces_) {
    Vector3 velocity = Vector3::Zero();
    for (const int n : face) velocity += point(state.v, n);
    power += FaceDiagonals(face, state.q).area().dot(velocity) / 4;
  }
  return course_.share(state) * pressure_ * power;
}

void Pressure::add_force(const State& state, VectorRef f) const {
  const double share = course_.share(state) * pressure_ / 4;
  for (const auto& face : faces_) {
    const Vector3 force = share * FaceDiagonals(face, state.q).area();
    for (const int n : face) point(f, n) += force;
  }
}

void Pressure::add_tangent(const State& state, double dq, double /*dv*/, Assembler& tangent) const {
  const double share = dq * course_.share(state) * pressure_ / 8;
  for (std::size_t e = 0; e < faces_.size(); ++e) {
    const FaceDiagonals d(faces_[e], state.q);
    add_shared_tangent(by_nodes(-share * cross_matrix(d.second), share * cross_matrix(d.first)), e, tangent);
  }
}

void Pressure::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (const auto& face : faces_) pattern.add_element(face);
}

}  // namespace sundrape

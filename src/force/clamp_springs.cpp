#include "sundrape/force/clamp_springs.hpp"

#include <stdexcept>

#include "sundrape/force/hinge_angle.hpp"

namespace sundrape {
namespace {

Vector3 edge(const ClampSpring& s, ConstVectorRef x) { return point(x, s.next) - point(x, s.node); }

}  // namespace

ClampSprings::ClampSprings(std::vector<ClampSpring> springs, double relaxation_time)
    : springs_(std::move(springs)), relaxation_time_(relaxation_time) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of bending must not be negative [s]");
  for (const auto& s : springs_)
    if (!(s.stiffness > 0)) throw std::invalid_argument("a clamp has no stiffness");
}

double ClampSprings::energy(const State& state) const {
  double sum = 0;
  for (const auto& s : springs_) {
    const double angle = HingeAngle(s.direction, edge(s, state.q), s.axis).angle;
    sum += 0.5 * s.stiffness * angle * angle;
  }
  return sum;
}

double ClampSprings::dissipated_power(const State& state) const {
  double sum = 0;
  for (const auto& s : springs_) {
    const double rate = HingeAngle(s.direction, edge(s, state.q), s.axis).gb.dot(edge(s, state.v));
    sum += relaxation_time_ * s.stiffness * rate * rate;
  }
  return sum;
}

void ClampSprings::add_force(const State& state, VectorRef f) const {
  for (const auto& s : springs_) {
    const HingeAngle hinge(s.direction, edge(s, state.q), s.axis);
    const Vector3 pull = s.stiffness * (hinge.angle + relaxation_time_ * hinge.gb.dot(edge(s, state.v))) * hinge.gb;
    point(f, s.next) -= pull;
    point(f, s.node) += pull;
  }
}

void ClampSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto& s = springs_[e];
    const Vector3 b = edge(s, state.q), rate = edge(s, state.v);
    const HingeAngle hinge(s.direction, b, s.axis);
    const Matrix3 curved = HingeCurvature(s.direction, b, s.axis).bb;
    const double viscosity = relaxation_time_ * s.stiffness;
    const double moment = s.stiffness * hinge.angle + viscosity * hinge.gb.dot(rate);
    Matrix3 block = -(dq * s.stiffness + dv * viscosity) * hinge.gb * hinge.gb.transpose() - dq * moment * curved;
    if (exact) block -= dq * viscosity * hinge.gb * (curved * rate).transpose();
    tangent.add_diagonal(e, 0, block);
    tangent.add_diagonal(e, 1, block);
    if (exact)
      tangent.add_general_pair(e, 0, 1, -block, -block);
    else
      tangent.add_pair(e, 0, 1, -block);
  }
}

void ClampSprings::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(2);
  for (const auto& s : springs_) pattern.add_element(std::array{s.node, s.next});
}

}  // namespace sundrape

#include "sundrape/force/clamp_springs.hpp"

#include <stdexcept>

#include <Eigen/Geometry>

#include "sundrape/force/bend_law.hpp"
#include "sundrape/force/hinge_angle.hpp"

namespace sundrape {
namespace {

Vector3 edge(const ClampSpring& s, ConstVectorRef x) { return point(x, s.next) - point(x, s.node); }

}  // namespace

ClampSprings::ClampSprings(std::vector<ClampSpring> springs, double relaxation_time, std::optional<MomentCurvature> law)
    : springs_(std::move(springs)),
      relaxation_time_(relaxation_time),
      law_(law && !law->is_linear() ? law : std::nullopt) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of bending must not be negative [s]");
  for (const auto& s : springs_) {
    if (!(s.stiffness > 0)) throw std::invalid_argument("a clamp has no stiffness");
    if (law_ && !(s.length > 0)) throw std::invalid_argument("a clamp with a law of bending has no length");
  }
}

double ClampSprings::energy(const State& state) const {
  double sum = 0;
  for (const auto& s : springs_) {
    const double angle = HingeAngle(s.direction, edge(s, state.q), s.axis).angle;
    sum += law_ ? s.stiffness * bend_response(*law_, s.length, angle).energy : 0.5 * s.stiffness * angle * angle;
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
    const Vector3 pull = this->pull(s, state);
    point(f, s.next) -= pull;
    point(f, s.node) += pull;
  }
}

Vector3 ClampSprings::pull(const ClampSpring& s, const State& state) const {
  const HingeAngle hinge(s.direction, edge(s, state.q), s.axis);
  const double turn = law_ ? bend_response(*law_, s.length, hinge.angle).turn : hinge.angle;
  return s.stiffness * (turn + relaxation_time_ * hinge.gb.dot(edge(s, state.v))) * hinge.gb;
}

Vector3 ClampSprings::couple(const State& state, const std::vector<bool>& nodes) const {
  Vector3 sum = Vector3::Zero();
  for (const auto& s : springs_)
    if (nodes[static_cast<std::size_t>(s.node)]) sum -= edge(s, state.q).cross(pull(s, state));
  return sum;
}

void ClampSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto& s = springs_[e];
    const Vector3 b = edge(s, state.q), rate = edge(s, state.v);
    const HingeAngle hinge(s.direction, b, s.axis);
    const Matrix3 curved = HingeCurvature(s.direction, b, s.axis).bb;
    double turn = hinge.angle, tangent_stiffness = s.stiffness;
    if (law_) {
      const auto bent = bend_response(*law_, s.length, turn);
      turn = bent.turn;
      tangent_stiffness *= bent.slope;
    }
    const double viscosity = relaxation_time_ * s.stiffness;
    const double moment = s.stiffness * turn + viscosity * hinge.gb.dot(rate);
    Matrix3 block = -(dq * tangent_stiffness + dv * viscosity) * hinge.gb * hinge.gb.transpose() - dq * moment * curved;
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

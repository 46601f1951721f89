#include "sundrape/force/clamp_springs.hpp"

#include <algorithm>
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
      turned_by_(springs_.size()),
      relaxation_time_(relaxation_time),
      law_(law && !law->is_linear() ? law : std::nullopt) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of bending must not be negative [s]");
  for (const auto& s : springs_) {
    if (!(s.stiffness > 0)) throw std::invalid_argument("a clamp has no stiffness");
    if (law_ && !(s.length > 0)) throw std::invalid_argument("a clamp with a law of bending has no length");
  }
}

void ClampSprings::turn_with(const std::vector<int>& nodes, const PathCourse& course) {
  for (std::size_t e = 0; e < springs_.size(); ++e)
    if (std::ranges::find(nodes, springs_[e].node) != nodes.end()) turned_by_[e].push_back(courses_.size());
  courses_.push_back(course);
}

void ClampSprings::open(const std::vector<int>& nodes) {
  for (auto& spring : springs_)
    if (std::ranges::find(nodes, spring.node) != nodes.end()) spring.stiffness = 0;
}

ClampSprings::Turns ClampSprings::turns(const State& state) const {
  Turns turns;
  for (const auto& course : courses_) {
    turns.rotation.push_back(course.placement(state).rotation);
    turns.spin.push_back(course.rate(state).spin);
  }
  return turns;
}

ClampSprings::Held ClampSprings::held(std::size_t spring, const Turns& turns, const State& state) const {
  const auto& s = springs_[spring];
  Held h{s.direction, s.axis, edge(s, state.q), edge(s, state.v), Vector3::Zero()};
  for (const auto k : turned_by_[spring]) {
    const auto& turn = turns.rotation[k];
    h.direction = turn * h.direction;
    h.axis = turn * h.axis;
    h.spin = turn * h.spin + turns.spin[k];
  }
  h.rate -= h.spin.cross(h.edge);
  return h;
}

double ClampSprings::energy(const State& state) const {
  const auto turns = this->turns(state);
  double sum = 0;
  for (std::size_t e = 0; e < springs_.size(); ++e) sum += stored(springs_[e], held(e, turns, state));
  return sum;
}

void ClampSprings::add_strain_energy(const State& state, VectorRef of_points) const {
  const auto turns = this->turns(state);
  for (std::size_t e = 0; e < springs_.size(); ++e)
    of_points[springs_[e].node] += stored(springs_[e], held(e, turns, state));
}

double ClampSprings::stored(const ClampSpring& s, const Held& h) const {
  const double angle = HingeAngle(h.direction, h.edge, h.axis).angle;
  return law_ ? s.stiffness * bend_response(*law_, s.length, angle).energy : 0.5 * s.stiffness * angle * angle;
}

double ClampSprings::dissipated_power(const State& state) const {
  const auto turns = this->turns(state);
  double sum = 0;
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto h = held(e, turns, state);
    const double rate = HingeAngle(h.direction, h.edge, h.axis).gb.dot(h.rate);
    sum += relaxation_time_ * springs_[e].stiffness * rate * rate;
  }
  return sum;
}

double ClampSprings::external_power(const State& state) const {
  if (courses_.empty()) return 0;
  const auto turns = this->turns(state);
  double sum = 0;
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto h = held(e, turns, state);
    sum -= pull(springs_[e], h).dot(h.spin.cross(h.edge));
  }
  return sum;
}

void ClampSprings::add_force(const State& state, VectorRef f) const {
  const auto turns = this->turns(state);
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto& s = springs_[e];
    const Vector3 pull = this->pull(s, held(e, turns, state));
    point(f, s.next) -= pull;
    point(f, s.node) += pull;
  }
}

Vector3 ClampSprings::pull(const ClampSpring& s, const Held& h) const {
  const HingeAngle hinge(h.direction, h.edge, h.axis);
  const double turn = law_ ? bend_response(*law_, s.length, hinge.angle).turn : hinge.angle;
  return s.stiffness * (turn + relaxation_time_ * hinge.gb.dot(h.rate)) * hinge.gb;
}

Vector3 ClampSprings::couple(const State& state, const std::vector<bool>& nodes) const {
  const auto turns = this->turns(state);
  Vector3 sum = Vector3::Zero();
  for (std::size_t e = 0; e < springs_.size(); ++e)
    if (const auto& s = springs_[e]; nodes[static_cast<std::size_t>(s.node)]) {
      const auto h = held(e, turns, state);
      sum -= h.edge.cross(pull(s, h));
    }
  return sum;
}

void ClampSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  const auto turns = this->turns(state);
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto& s = springs_[e];
    const auto h = held(e, turns, state);
    const HingeAngle hinge(h.direction, h.edge, h.axis);
    const Matrix3 curved = HingeCurvature(h.direction, h.edge, h.axis).bb;
    double turn = hinge.angle, tangent_stiffness = s.stiffness;
    if (law_) {
      const auto bent = bend_response(*law_, s.length, turn);
      turn = bent.turn;
      tangent_stiffness *= bent.slope;
    }
    const double viscosity = relaxation_time_ * s.stiffness;
    const double moment = s.stiffness * turn + viscosity * hinge.gb.dot(h.rate);
    Matrix3 block = -(dq * tangent_stiffness + dv * viscosity) * hinge.gb * hinge.gb.transpose() - dq * moment * curved;
    if (exact) block -= dq * viscosity * hinge.gb * (curved * h.rate + h.spin.cross(hinge.gb)).transpose();
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

#include "sundrape/force/director_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace sundrape {

DirectorLength::DirectorLength(std::vector<DirectorSpring> springs, double director_length, double relaxation_time)
    : springs_(std::move(springs)), length_(director_length), relaxation_time_(relaxation_time) {
  if (!(director_length > 0)) throw std::invalid_argument("the length of directors must be positive [m]");
  if (!(relaxation_time >= 0)) throw std::invalid_argument("a relaxation time must not be negative [s]");
  for (const auto& s : springs_)
    if (!(s.stiffness > 0)) throw std::invalid_argument("a director has no stiffness");
}

double DirectorLength::stored(const DirectorSpring& s, const State& state) const {
  const double strain = 0.5 * (point(state.q, s.point).squaredNorm() / (length_ * length_) - 1);
  return 0.5 * s.stiffness * strain * strain;
}

double DirectorLength::energy(const State& state) const {
  double sum = 0;
  for (const auto& s : springs_) sum += stored(s, state);
  return sum;
}

void DirectorLength::add_strain_energy(const State& state, VectorRef of_points) const {
  for (const auto& s : springs_) of_points[s.point] += stored(s, state);
}

double DirectorLength::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  double sum = 0;
  for (const auto& s : springs_) {
    const double rate = point(state.q, s.point).dot(point(state.v, s.point)) / (length_ * length_);
    sum += relaxation_time_ * s.stiffness * rate * rate;
  }
  return sum;
}

void DirectorLength::add_force(const State& state, VectorRef f) const {
  const double per_square = 1 / (length_ * length_);
  for (const auto& s : springs_) {
    const Vector3 t = point(state.q, s.point);
    double strain = 0.5 * (t.squaredNorm() * per_square - 1);
    if (relaxation_time_ > 0) strain += relaxation_time_ * per_square * t.dot(point(state.v, s.point));
    point(f, s.point) -= s.stiffness * strain * per_square * t;
  }
}

void DirectorLength::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const double per_square = 1 / (length_ * length_);
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto& s = springs_[e];
    const Vector3 t = point(state.q, s.point);
    double strain = 0.5 * (t.squaredNorm() * per_square - 1);
    if (relaxation_time_ > 0) strain += relaxation_time_ * per_square * t.dot(point(state.v, s.point));
    Matrix3 block = (dq + dv * relaxation_time_) * s.stiffness * per_square * per_square * t * t.transpose();
    block.diagonal().array() += dq * s.stiffness * strain * per_square;
    if (exact)
      block += dq * relaxation_time_ * s.stiffness * per_square * per_square * t * point(state.v, s.point).transpose();
    tangent.add_diagonal(e, 0, -block);
  }
}

void DirectorLength::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(1);
  for (const auto& s : springs_) pattern.add_element(std::array{s.point});
}

double DirectorLength::largest_error(ConstVectorRef q) const {
  double largest = 0;
  for (const auto& s : springs_) largest = std::max(largest, std::abs(point(q, s.point).norm() / length_ - 1));
  return largest;
}

}  // namespace sundrape

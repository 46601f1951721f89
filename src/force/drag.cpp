#include "sundrape/force/drag.hpp"

#include <array>
#include <stdexcept>

namespace sundrape {

Drag::Drag(Vector mass, double rate) : mass_(std::move(mass)), rate_(rate) {
  if (!(rate >= 0)) throw std::invalid_argument("mass-proportional damping must not be negative [1/s]");
}

double Drag::dissipated_power(const State& state) const {
  double sum = 0;
  for (int i = 0; i < mass_.size(); ++i) sum += rate_ * mass_[i] * point(state.v, i).squaredNorm();
  return sum;
}

void Drag::add_force(const State& state, VectorRef f) const {
  for (int i = 0; i < mass_.size(); ++i) point(f, i) -= rate_ * mass_[i] * point(state.v, i);
}

void Drag::add_tangent(const State& /*state*/, double /*dq*/, double dv, Assembler& tangent) const {
  for (int i = 0; i < mass_.size(); ++i)
    tangent.add_diagonal(static_cast<std::size_t>(i), 0, -dv * rate_ * mass_[i] * Matrix3::Identity());
}

void Drag::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(1);
  for (int i = 0; i < mass_.size(); ++i) pattern.add_element(std::array{i});
}

}  // namespace sundrape

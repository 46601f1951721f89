#include "sundrape/system/parameter_derivative.hpp"

#include <stdexcept>

namespace sundrape {
namespace {

constexpr double per_change = 1 / (2 * ParameterDerivative::relative_change);

}  // namespace

ParameterDerivative::ParameterDerivative(const System& lower, const System& upper)
    : lower_(lower), upper_(upper), row_mass_(per_change * (upper.row_mass() - lower.row_mass())) {
  if (lower.unknowns().point_of_row() != upper.unknowns().point_of_row() ||
      lower.mass().size() != upper.mass().size() || lower.terms().size() != upper.terms().size())
    throw std::invalid_argument("the parameter changes which points, supports or forces there are");
  for (std::size_t k = 0; k < lower.terms().size(); ++k)
    if (lower.terms()[k]->name() != upper.terms()[k]->name())
      throw std::invalid_argument("the parameter changes which forces there are");
  for (auto* rows : {&rows_q_, &rows_v_}) rows->resize(lower.unknowns().size());
  for (auto* all : {&lower_q_, &lower_v_, &upper_q_, &upper_v_, &lower_f_, &upper_f_, &sum_})
    all->resize(3 * lower.mass().size());
}

void ParameterDerivative::place(const System& system, double time, int stage, Vector& q, Vector& v) {
  const auto& unknowns = system.unknowns();
  for (const auto& [row, component] : unknowns.held_components())
    rows_q_[3 * row + component] =
        system.rest()[3 * unknowns.point_of_row()[static_cast<std::size_t>(row)] + component];
  system.expand(time, rows_q_, rows_v_, q, v);
  if (stage == 0) return;
  system.carry(time, stage, q);
  v.setZero();
}

void ParameterDerivative::force(const State& all, VectorRef rows) {
  const auto& unknowns = lower_.unknowns();
  unknowns.gather(all.q, rows_q_);
  unknowns.gather(all.v, rows_v_);
  place(lower_, all.time, all.stage, lower_q_, lower_v_);
  place(upper_, all.time, all.stage, upper_q_, upper_v_);
  sum_.setZero();
  for (std::size_t k = 0; k < lower_.terms().size(); ++k) {
    lower_f_.setZero();
    upper_f_.setZero();
    lower_.terms()[k]->add_force({all.time, lower_q_, lower_v_, all.stage}, lower_f_);
    upper_.terms()[k]->add_force({all.time, upper_q_, upper_v_, all.stage}, upper_f_);
    sum_ += upper_f_ - lower_f_;
  }
  unknowns.gather(sum_, rows);
  rows *= per_change;
  unknowns.clear_held(rows);
}

void ParameterDerivative::supports(double time, int stage, VectorRef q, VectorRef v) {
  rows_q_.setZero();
  rows_v_.setZero();
  place(lower_, time, stage, lower_q_, lower_v_);
  place(upper_, time, stage, upper_q_, upper_v_);
  q = per_change * (upper_q_ - lower_q_);
  v = per_change * (upper_v_ - lower_v_);
}

}  // namespace sundrape

#include "sundrape/system/parameter_derivative.hpp"

#include <stdexcept>

namespace sundrape {
namespace {

constexpr double per_change = 1 / ParameterDerivative::relative_change;

/// All points at the unknowns in rows, with what the system holds where it holds it. The rows of held components are
/// overwritten.
void place(const System& system, double time, int stage, Vector& rows_q, ConstVectorRef rows_v, Vector& q, Vector& v) {
  const auto& unknowns = system.unknowns();
  for (const auto& [row, component] : unknowns.held_components())
    rows_q[3 * row + component] = system.rest()[3 * unknowns.point_of_row()[static_cast<std::size_t>(row)] + component];
  system.expand(time, rows_q, rows_v, q, v);
  if (stage == 0) return;
  system.carry(time, stage, q);
  v.setZero();
}

}  // namespace

TermForces::TermForces(const System& system) : system_(system), of_term_(system.terms().size()) {
  for (auto* rows : {&rows_q_, &rows_v_}) rows->setZero(system.unknowns().size());
  for (auto* all : {&q_, &v_, &sum_}) all->setZero(3 * system.mass().size());
  for (auto& force : of_term_) force.setZero(sum_.size());
}

void TermForces::evaluate(const State& all) {
  time_ = all.time;
  stage_ = all.stage;
  system_.unknowns().gather(all.q, rows_q_);
  system_.unknowns().gather(all.v, rows_v_);
  place(system_, time_, stage_, rows_q_, rows_v_, q_, v_);
  sum_.setZero();
  for (std::size_t k = 0; k < of_term_.size(); ++k) {
    of_term_[k].setZero();
    system_.terms()[k]->add_force({time_, q_, v_, stage_}, of_term_[k]);
    sum_ += of_term_[k];
  }
}

ParameterDerivative::ParameterDerivative(const System& system, const System& changed)
    : system_(system), changed_(changed), row_mass_(per_change * (changed.row_mass() - system.row_mass())) {
  if (system.unknowns().point_of_row() != changed.unknowns().point_of_row() ||
      system.mass().size() != changed.mass().size() || system.terms().size() != changed.terms().size())
    throw std::invalid_argument("the parameter changes which points, supports or forces there are");
  for (std::size_t k = 0; k < system.terms().size(); ++k)
    if (system.terms()[k]->name() != changed.terms()[k]->name())
      throw std::invalid_argument("the parameter changes which forces there are");
  for (auto* rows : {&rows_q_, &rows_v_}) rows->resize(system.unknowns().size());
  for (auto* all : {&q_, &v_, &changed_q_, &changed_v_, &force_, &difference_}) all->resize(3 * system.mass().size());
}

void ParameterDerivative::force(const TermForces& here, VectorRef rows) {
  rows_q_ = here.rows_q_;
  place(changed_, here.time_, here.stage_, rows_q_, here.rows_v_, changed_q_, changed_v_);
  difference_.setZero();
  for (std::size_t k = 0; k < changed_.terms().size(); ++k) {
    force_.setZero();
    changed_.terms()[k]->add_force({here.time_, changed_q_, changed_v_, here.stage_}, force_);
    difference_ += force_ - here.of_term_[k];
  }
  changed_.unknowns().gather(difference_, rows);
  rows *= per_change;
  changed_.unknowns().clear_held(rows);
}

void ParameterDerivative::supports(double time, int stage, VectorRef q, VectorRef v) {
  rows_q_.setZero();
  rows_v_.setZero();
  place(system_, time, stage, rows_q_, rows_v_, q_, v_);
  place(changed_, time, stage, rows_q_, rows_v_, changed_q_, changed_v_);
  q = per_change * (changed_q_ - q_);
  v = per_change * (changed_v_ - v_);
}

}  // namespace sundrape

#include "sundrape/system/condensed_newton.hpp"

#include <algorithm>

#include "sundrape/system/stopwatch.hpp"

namespace sundrape {
namespace {

constexpr double loosest = 0.1;     // tolerance of a linear solve
constexpr double rounding = 1e-12;  // c q − v is known to this part of c q: some thousand roundings of it

}  // namespace

CondensedNewton::CondensedNewton(const System& system, std::unique_ptr<LinearSolver> solver, double tolerance)
    : system_(system),
      solver_(std::move(solver)),
      matrix_(system.structure(), solver_->symmetry()),
      of_structure_(system.structures()),
      tolerance_(tolerance) {
  const auto all = 3 * static_cast<Eigen::Index>(system.unknowns().points());
  q_.resize(all);
  v_.resize(all);
  shifted_v_.resize(all);
  work_.resize(all);
  right_side_.resize(system.unknowns().size());
  force_.resize(system.unknowns().size());
  solver_->analyse(system.structure());
}

FactorStatus CondensedNewton::prepare(double time, double c, ConstVectorRef q, ConstVectorRef v) {
  {
    const Stopwatch watch(counters_.assembly_seconds);
    if (c != c_ || time != time_) first_norm_ = 0;
    c_ = c;
    time_ = time;
    system_.expand(time, q, v, q_, v_);
    force_known_ = false;
    if (const long now = system_.adapt({time, q_, v_}); now != of_structure_) {
      of_structure_ = now;
      matrix_ = BlockMatrix(system_.structure(), solver_->symmetry());
      solver_->analyse(system_.structure());
      ++counters_.patterns;
    }
    matrix_.set_zero();
    matrix_.add_diagonal(system_.row_mass(), c * c);
    system_.add_tangent({time, q_, v_}, -1, -c, matrix_);
    system_.hold(matrix_);
  }
  const Stopwatch watch(counters_.factor_seconds);
  ++counters_.factorizations;
  const auto status = solver_->factor(matrix_);
  ready_ = status == FactorStatus::ok;
  if (status != FactorStatus::ok) ++counters_.failures;
  return status;
}

SolveReport CondensedNewton::solve(ConstVectorRef r_q, ConstVectorRef r_v, VectorRef dq, VectorRef dv, double largest) {
  const Stopwatch watch(counters_.solve_seconds);
  right_side_ = r_v;
  if (r_q.lpNorm<Eigen::Infinity>() > rounding * c_ * q_.lpNorm<Eigen::Infinity>()) {
    for (int r = 0; r < system_.unknowns().rows(); ++r)
      point(right_side_, r) += c_ * system_.row_mass()[r] * point(r_q, r);
    add_damping_product(r_q, right_side_);
  }
  system_.unknowns().clear_held(right_side_);
  // later iterations of a step need no more digits after the point than its first
  const double norm = right_side_.norm();
  if (first_norm_ == 0) first_norm_ = norm;
  const double tolerance = norm > 0 ? std::clamp(tolerance_ * first_norm_ / norm, tolerance_, loosest) : tolerance_;
  auto report = solver_->solve(right_side_, dq, tolerance, largest);
  ++counters_.solves;
  counters_.linear_iterations += report.iterations;
  if (report.ok && !dq.allFinite()) report = {false, report.iterations, "the solution is not finite"};
  if (!report.ok) ++counters_.failures;
  system_.unknowns().clear_held(dq);  // zero only to the tolerance of an iterative solver, and errors would add up
  dv = c_ * dq - r_q;
  system_.unknowns().clear_held(dv);
  return report;
}

void CondensedNewton::know_forces(ConstVectorRef rows) {
  force_ = rows;
  force_known_ = true;
}

void CondensedNewton::add_damping_product(ConstVectorRef r_q, VectorRef right_side) {
  const auto& unknowns = system_.unknowns();
  if (!force_known_) {
    system_.force({time_, q_, v_}, work_);
    unknowns.gather(work_, force_);
    force_known_ = true;
  }
  shifted_v_.setZero();
  unknowns.scatter(r_q, shifted_v_);
  shifted_v_ += v_;
  system_.force({time_, q_, shifted_v_}, work_);
  for (int r = 0; r < unknowns.rows(); ++r)
    point(right_side, r) += point(force_, r) - point(work_, unknowns.point_of_row()[static_cast<std::size_t>(r)]);
}

}  // namespace sundrape

#include "sundrape/statics/tangent.hpp"

#include <cmath>

#include "sundrape/linalg/cholesky.hpp"
#include "sundrape/linalg/ldlt.hpp"
#include "sundrape/linalg/lu.hpp"

namespace sundrape {

Tangent::Tangent(const System& system, double neutral_frequency)
    : system_(system),
      shift_(neutral_frequency * neutral_frequency * system.row_mass()),
      still_(Vector::Zero(3 * system.mass().size())),
      matrix_(system.structure(), system.has_symmetric_tangent() ? Symmetry::symmetric : Symmetry::unsymmetric),
      of_structure_(system.structures()) {
  if (matrix_.symmetry() == Symmetry::unsymmetric)
    lu_ = std::make_unique<Lu>();
  else
    cholesky_ = std::make_unique<Cholesky>();
}

FactorStatus Tangent::factor(const State& all) {
  if (const long now = system_.adapt({all.time, all.q, still_, all.stage}); now != of_structure_) {
    of_structure_ = now;
    matrix_ = BlockMatrix(system_.structure(), matrix_.symmetry());
    for (auto* solver : {cholesky_.get(), ldlt_.get(), lu_.get()})
      if (solver) solver->analyse(system_.structure());
  }
  matrix_.set_zero();
  matrix_.add_diagonal(shift_, 1);
  system_.add_tangent({all.time, all.q, still_, all.stage}, -1, 0, matrix_);
  system_.hold(matrix_);
  ++factorizations_;
  ldlt_current_ = false;
  if (cholesky_) return factor_symmetric();
  used_ = lu_.get();
  return lu_->factor(matrix_);
}

FactorStatus Tangent::factor_symmetric() {
  if (!was_indefinite_) {
    used_ = cholesky_.get();
    if (cholesky_->factor(matrix_) == FactorStatus::ok) return FactorStatus::ok;
  }
  if (!ldlt_) ldlt_ = std::make_unique<Ldlt>();
  used_ = ldlt_.get();
  const auto status = ldlt_->factor(matrix_);
  ldlt_current_ = true;
  was_indefinite_ = ldlt_->negative_pivots().value_or(1) > 0;
  return status;
}

SolveReport Tangent::solve_stiffness(ConstVectorRef b, VectorRef x) {
  constexpr int corrections = 3;  // each gains what ε² M is small against K, and rounding of the factor
  auto report = solve(b, x);
  Vector rest(b.size()), correction(b.size());
  for (int k = 0; k < corrections && report.ok; ++k) {
    matrix_.multiply(x, rest);
    for (int r = 0; r < static_cast<int>(shift_.size()); ++r) point(rest, r) -= shift_[r] * point(x, r);
    rest = b - rest;
    system_.unknowns().clear_held(rest);
    report = solve(rest, correction);
    x += correction;
  }
  return report;
}

std::optional<int> Tangent::negative_pivots() {
  if (used_ == cholesky_.get() && cholesky_) return cholesky_->negative_pivots();
  if (!ldlt_current_) {
    if (!ldlt_) ldlt_ = std::make_unique<Ldlt>();
    (void)ldlt_->factor(matrix_);
    ldlt_current_ = true;
  }
  return ldlt_->negative_pivots();
}

double Tangent::neutral_part(const Vector& x) const {
  double shift = 0;
  for (int r = 0; r < static_cast<int>(shift_.size()); ++r) shift += shift_[r] * point(x, r).squaredNorm();
  Vector product(x.size());
  matrix_.multiply(x, product);
  return shift / std::abs(x.dot(product));
}

}  // namespace sundrape

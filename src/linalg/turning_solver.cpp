#include "sundrape/linalg/turning_solver.hpp"

#include <stdexcept>
#include <utility>

namespace sundrape {

TurningSolver::TurningSolver(std::unique_ptr<LinearSolver> iterative, std::unique_ptr<LinearSolver> direct)
    : iterative_(std::move(iterative)), direct_(std::move(direct)) {
  if (iterative_->symmetry() != direct_->symmetry())
    throw std::invalid_argument("two solvers of one system have to want the same matrix");
}

void TurningSolver::analyse(const BlockStructure& structure) {
  iterative_->analyse(structure);
  structure_ = &structure;
  is_direct_ = false;
}

FactorStatus TurningSolver::factor_directly(const BlockMatrix& matrix) {
  if (structure_ != nullptr) direct_->analyse(*std::exchange(structure_, nullptr));
  const auto status = direct_->factor(matrix);
  is_direct_ = status == FactorStatus::ok;
  return status;
}

FactorStatus TurningSolver::factor(const BlockMatrix& matrix) {
  matrix_ = &matrix;
  return is_direct_ ? factor_directly(matrix) : iterative_->factor(matrix);
}

SolveReport TurningSolver::solve(ConstVectorRef b, VectorRef x, double tolerance, double largest) {
  if (is_direct_) return direct_->solve(b, x, tolerance, largest);
  auto report = iterative_->solve(b, x, tolerance, largest);
  if (report.ok || report.indefinite || matrix_ == nullptr) return report;
  if (factor_directly(*matrix_) != FactorStatus::ok)
    return {.ok = false,
            .iterations = report.iterations,
            .problem = "the matrix is not positive definite",
            .indefinite = true};
  const int tried = report.iterations;
  report = direct_->solve(b, x, tolerance, largest);
  report.iterations += tried;
  return report;
}

}  // namespace sundrape

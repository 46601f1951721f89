#include "sundrape/linalg/refined_solver.hpp"

#include <algorithm>
#include <stdexcept>

#include "sundrape/linalg/lu.hpp"

namespace sundrape {
namespace {

constexpr double inner_tolerance = 1e-3;  // of one correction: most of them come out of single precision
constexpr double slow = 0.3;              // part of the residual that a correction may leave
constexpr int most_corrections = 20;

}  // namespace

RefinedSolver::RefinedSolver(std::unique_ptr<LinearSolver> symmetric) : symmetric_(std::move(symmetric)) {
  if (symmetric_->symmetry() != Symmetry::symmetric)
    throw std::invalid_argument("what is refined is a solver of symmetric systems");
}

void RefinedSolver::analyse(const BlockStructure& structure) {
  structure_ = &structure;
  part_.emplace(structure, Symmetry::symmetric);
  symmetric_->analyse(structure);
  direct_.reset();
}

FactorStatus RefinedSolver::factor_directly() {
  if (!direct_) {
    direct_ = std::make_unique<Lu>();
    direct_->analyse(*structure_);
  }
  is_direct_ = true;
  return direct_->factor(*matrix_);
}

FactorStatus RefinedSolver::factor(const BlockMatrix& matrix) {
  if (structure_ != &matrix.structure()) analyse(matrix.structure());
  matrix_ = &matrix;
  is_direct_ = false;
  part_->set_zero();
  for (int row = 0; row < structure_->size(); ++row) {
    const auto diagonal = structure_->diagonal(row);
    for (auto block = structure_->row_start[static_cast<std::size_t>(row)]; block < diagonal; ++block)
      part_->lower(block) = 0.5 * (matrix.lower(block) + matrix.upper(block).transpose());
    part_->lower(diagonal) = 0.5 * (matrix.lower(diagonal) + matrix.lower(diagonal).transpose());
  }
  return symmetric_->factor(*part_) == FactorStatus::ok ? FactorStatus::ok : factor_directly();
}

SolveReport RefinedSolver::solve(ConstVectorRef b, VectorRef x, double tolerance, double largest) {
  if (matrix_ == nullptr) return {.ok = false, .problem = "there is no matrix"};
  const double size = b.norm();
  x.setZero();
  if (size == 0) return {};
  SolveReport report;
  rest_ = b;
  correction_.resize(b.size());
  double left = size;
  for (int k = 0; k < most_corrections && !is_direct_; ++k) {
    const auto inner = symmetric_->solve(rest_, correction_, std::max(inner_tolerance, 0.5 * tolerance * size / left),
                                         largest);
    report.iterations += inner.iterations;
    if (!inner.ok) break;
    x += correction_;
    matrix_->multiply(x, rest_);
    rest_ = b - rest_;
    const double now = rest_.norm();
    if (now <= tolerance * size) return report;
    if (!(now <= slow * left)) break;
    left = now;
  }
  if (!is_direct_ && factor_directly() != FactorStatus::ok)
    return {.ok = false, .iterations = report.iterations, .problem = "the matrix is singular"};
  const auto direct = direct_->solve(b, x, tolerance, largest);
  report.ok = direct.ok;
  report.problem = direct.problem;
  return report;
}

}  // namespace sundrape

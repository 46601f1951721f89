#include "sundrape/linalg/refined_solver.hpp"

#include <stdexcept>

#include <Eigen/QR>

#include "sundrape/linalg/lu.hpp"

namespace sundrape {
namespace {

constexpr double inner_tolerance = 0.1;  // of one direction, which single precision is enough for
constexpr int most_directions = 20;

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
  if (!is_direct_ && iterate(b, x, tolerance, largest, report)) return report;
  if (!is_direct_ && factor_directly() != FactorStatus::ok)
    return {.ok = false, .iterations = report.iterations, .problem = "the matrix is singular"};
  const auto direct = direct_->solve(b, x, tolerance, largest);
  report.ok = direct.ok;
  report.problem = direct.problem;
  return report;
}

/// Flexible GMRES: x = Z y with z_k the other solver's answer to direction v_k, |b − A Z y| least (Saad 1993).
bool RefinedSolver::iterate(ConstVectorRef b, VectorRef x, double tolerance, double largest, SolveReport& report) {
  const double size = b.norm();
  directions_.assign(1, b / size);
  answers_.clear();
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most_directions + 1, most_directions);
  for (int k = 0; k < most_directions; ++k) {
    Vector answer(b.size()), image(b.size());
    const auto inner = symmetric_->solve(directions_.back(), answer, inner_tolerance, largest);
    report.iterations += inner.iterations;
    if (!inner.ok) return false;
    matrix_->multiply(answer, image);
    answers_.push_back(std::move(answer));
    for (int j = 0; j <= k; ++j) {
      const auto& direction = directions_[static_cast<std::size_t>(j)];
      hessenberg(j, k) = direction.dot(image);
      image -= hessenberg(j, k) * direction;
    }
    hessenberg(k + 1, k) = image.norm();
    const Eigen::MatrixXd seen = hessenberg.topLeftCorner(k + 2, k + 1);
    Vector wanted = Vector::Zero(k + 2);
    wanted[0] = size;
    const Vector y = seen.householderQr().solve(wanted);
    const double left = (seen * y - wanted).norm();
    if (left <= tolerance * size || hessenberg(k + 1, k) == 0) {
      for (int j = 0; j <= k; ++j) x += y[j] * answers_[static_cast<std::size_t>(j)];
      return left <= tolerance * size;
    }
    directions_.emplace_back(image / hessenberg(k + 1, k));
  }
  return false;
}

}  // namespace sundrape

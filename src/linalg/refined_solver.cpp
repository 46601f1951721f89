#include "sundrape/linalg/refined_solver.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

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

/// Flexible GMRES for one right side: x = Z y with z_k the other solver's answer to direction v_k, |b − A Z y| least
/// (Saad 1993).
class RefinedSolver::Course {
 public:
  Course(ConstVectorRef b, double tolerance)
      : size_(b.norm()),
        tolerance_(tolerance),
        hessenberg_(Eigen::MatrixXd::Zero(most_directions + 1, most_directions)) {
    if (size_ > 0) directions_.emplace_back(b / size_);
    converged_ = size_ == 0;
  }

  [[nodiscard]] bool converged() const { return converged_; }
  [[nodiscard]] const Vector& direction() const { return directions_.back(); }
  /// Takes the answer to the direction and its image under the matrix; false where that leads no further.
  [[nodiscard]] bool take(Vector answer, Vector image) {
    const auto k = static_cast<Eigen::Index>(answers_.size());
    answers_.push_back(std::move(answer));
    for (Eigen::Index j = 0; j <= k; ++j) {
      const auto& direction = directions_[static_cast<std::size_t>(j)];
      hessenberg_(j, k) = direction.dot(image);
      image -= hessenberg_(j, k) * direction;
    }
    const double rest = image.norm();
    hessenberg_(k + 1, k) = rest;
    const Eigen::MatrixXd seen = hessenberg_.topLeftCorner(k + 2, k + 1);
    Vector wanted = Vector::Zero(k + 2);
    wanted[0] = size_;
    y_ = seen.householderQr().solve(wanted);
    converged_ = (seen * y_ - wanted).norm() <= tolerance_ * size_;
    if (!converged_ && rest > 0) directions_.emplace_back(image / rest);
    return converged_ || rest > 0;
  }
  void add_solution(VectorRef x) const {
    for (std::size_t j = 0; j < answers_.size(); ++j) x += y_[static_cast<Eigen::Index>(j)] * answers_[j];
  }

 private:
  double size_, tolerance_;
  bool converged_ = false;
  Eigen::MatrixXd hessenberg_;
  Vector y_;
  std::vector<Vector> directions_, answers_;
};

SolveReport RefinedSolver::solve(ConstVectorRef b, VectorRef x, double tolerance, double /*largest*/) {
  Eigen::MatrixXd answer;
  auto report = solve_all(b, answer, tolerance);
  if (answer.rows() == x.size()) x = answer;
  return report;
}

SolveReport RefinedSolver::solve_all(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance) {
  if (matrix_ == nullptr) return {.ok = false, .problem = "there is no matrix"};
  SolveReport report;
  if (!is_direct_ && iterate(b, x, tolerance, report)) return report;
  if (!is_direct_ && factor_directly() != FactorStatus::ok)
    return {.ok = false, .iterations = report.iterations, .problem = "the matrix is singular"};
  auto direct = direct_->solve_all(b, x, tolerance);
  direct.iterations = report.iterations;
  return direct;
}

bool RefinedSolver::iterate(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance, SolveReport& report) {
  std::vector<Course> courses;
  for (const auto& column : b.colwise()) courses.emplace_back(column, tolerance);
  Eigen::MatrixXd directions, answers, images;
  for (int k = 0;; ++k) {
    std::vector<Course*> open;
    for (auto& course : courses)
      if (!course.converged()) open.push_back(&course);
    if (open.empty()) break;
    if (k == most_directions) return false;
    directions.resize(b.rows(), std::ssize(open));
    for (std::size_t i = 0; i < open.size(); ++i) directions.col(static_cast<Eigen::Index>(i)) = open[i]->direction();
    const auto inner = symmetric_->solve_all(directions, answers, inner_tolerance);
    report.iterations += inner.iterations;
    if (!inner.ok) return false;
    matrix_->multiply_all(answers, images);
    for (Eigen::Index i = 0; i < answers.cols(); ++i)
      if (!open[static_cast<std::size_t>(i)]->take(answers.col(i), images.col(i))) return false;
  }
  x.setZero(b.rows(), b.cols());
  for (std::size_t j = 0; j < courses.size(); ++j) courses[j].add_solution(x.col(static_cast<Eigen::Index>(j)));
  return true;
}

}  // namespace sundrape

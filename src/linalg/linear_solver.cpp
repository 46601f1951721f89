#include "sundrape/linalg/linear_solver.hpp"

#include <stdexcept>
#include <utility>

#include "sundrape/linalg/cholesky.hpp"
#include "sundrape/linalg/conjugate_gradients.hpp"
#include "sundrape/linalg/lu.hpp"

namespace sundrape {

SolveReport LinearSolver::solve_all(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance) {
  SolveReport all;
  x.resize(b.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    auto one = solve(b.col(j), x.col(j), tolerance);
    one.iterations += all.iterations;
    if (!one.ok) return one;
    all = std::move(one);
  }
  return all;
}

std::unique_ptr<LinearSolver> make_linear_solver(SolverKind kind) {
  switch (kind) {
    case SolverKind::conjugate_gradients:
      return std::make_unique<ConjugateGradients>();
    case SolverKind::cholesky:
      return std::make_unique<Cholesky>();
    case SolverKind::lu:
      return std::make_unique<Lu>();
  }
  throw std::invalid_argument("no such kind of linear solver");
}

}  // namespace sundrape

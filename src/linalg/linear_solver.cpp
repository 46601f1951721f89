#include "sundrape/linalg/linear_solver.hpp"

#include <stdexcept>

#include "sundrape/linalg/cholesky.hpp"
#include "sundrape/linalg/conjugate_gradients.hpp"
#include "sundrape/linalg/lu.hpp"

namespace sundrape {

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

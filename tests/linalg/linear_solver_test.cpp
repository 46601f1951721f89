#include "sundrape/linalg/linear_solver.hpp"

#include <gtest/gtest.h>

#include "solver_checks.hpp"

namespace sundrape {
namespace {

TEST(LinearSolver, EveryKindSolvesTheMatrixThatItAsksFor) {
  for (const auto kind : {SolverKind::conjugate_gradients, SolverKind::cholesky, SolverKind::lu}) {
    const auto solver = make_linear_solver(kind);
    SCOPED_TRACE(solver->name());
    const auto net = net_matrix({.nodes_per_side = 9, .symmetry = solver->symmetry()});
    solver->analyse(*net.structure);
    expect_solves(*solver, *net.matrix, 1e-8, 1e-6);
  }
}

TEST(LinearSolver, AnotherStructureIsAnalysedAnew) {
  for (const auto kind : {SolverKind::conjugate_gradients, SolverKind::cholesky, SolverKind::lu}) {
    const auto solver = make_linear_solver(kind);
    SCOPED_TRACE(solver->name());
    for (const int side : {9, 5, 12}) {
      const auto net = net_matrix({.nodes_per_side = side, .symmetry = solver->symmetry()});
      solver->analyse(*net.structure);
      expect_solves(*solver, *net.matrix, 1e-8, 1e-6);
    }
  }
}

}  // namespace
}  // namespace sundrape

#include "sundrape/linalg/turning_solver.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sundrape/linalg/cholesky.hpp"
#include "sundrape/linalg/conjugate_gradients.hpp"
#include "sundrape/linalg/lu.hpp"

#include "solver_checks.hpp"

namespace sundrape {
namespace {

TurningSolver turning_after(int iterations) {
  return {std::make_unique<ConjugateGradients>(nullptr, iterations), std::make_unique<Cholesky>()};
}

TEST(TurningSolver, SolvesDefiniteSystemsByEitherOfItsSolvers) {
  auto patient = turning_after(500), hasty = turning_after(1);
  expect_solves_definite_systems(patient);
  expect_solves_definite_systems(hasty);
}

TEST(TurningSolver, TurnsToTheDirectSolverWhereIterationsBecomeMany) {
  const auto heavy = net_matrix({.nodes_per_side = 12, .rate = 3000}),
             light = net_matrix({.nodes_per_side = 12, .rate = 10});
  const Vector b = random_vector(3 * heavy.matrix->size(), 1);
  Vector x(b.size());
  auto solver = turning_after(8);  // enough for the heavy one alone
  solver.analyse(*heavy.structure);
  ASSERT_EQ(solver.factor(*heavy.matrix), FactorStatus::ok);
  EXPECT_GT(solver.solve(b, x, 1e-2).iterations, 0);
  ASSERT_EQ(solver.factor(*light.matrix), FactorStatus::ok);
  EXPECT_TRUE(solver.solve(b, x, 1e-2).ok);
  Vector product(b.size());
  light.matrix->multiply(x, product);
  EXPECT_LT((b - product).norm(), 1e-10 * b.norm());  // solved directly, to round-off
  ASSERT_EQ(solver.factor(*heavy.matrix), FactorStatus::ok);
  EXPECT_EQ(solver.solve(b, x, 1e-2).iterations, 0);  // and so from there on
}

TEST(TurningSolver, GoesBackToIterationsAfterAnIndefiniteMatrix) {
  const auto heavy = net_matrix({.nodes_per_side = 12, .rate = 3000}),
             light = net_matrix({.nodes_per_side = 12, .rate = 10});
  const auto indefinite = net_matrix({.nodes_per_side = 12, .rate = 10});
  indefinite.matrix->add_diagonal(Vector::Ones(indefinite.matrix->size()),
                                  -1e3 * indefinite.matrix->diagonal(0).trace());
  const Vector b = random_vector(3 * heavy.matrix->size(), 1);
  Vector x(b.size());
  auto solver = turning_after(8);
  solver.analyse(*heavy.structure);
  ASSERT_EQ(solver.factor(*light.matrix), FactorStatus::ok);
  ASSERT_TRUE(solver.solve(b, x, 1e-2).ok);
  EXPECT_EQ(solver.factor(*indefinite.matrix), FactorStatus::not_positive_definite);
  ASSERT_EQ(solver.factor(*heavy.matrix), FactorStatus::ok);
  EXPECT_GT(solver.solve(b, x, 1e-2).iterations, 0);
}

TEST(TurningSolver, RefusesSolversOfDifferentMatrices) {
  EXPECT_THROW(TurningSolver(std::make_unique<ConjugateGradients>(), make_linear_solver(SolverKind::lu)),
               std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/linalg/cholesky.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "solver_checks.hpp"

namespace sundrape {
namespace {

TEST(Cholesky, SolvesDefiniteSystems) {
  Cholesky solver;
  expect_solves_definite_systems(solver);
}

// CHOLMOD factors the small net simplicially, the large one by supernodes.
TEST(Cholesky, ReportsAnIndefiniteMatrixAndRecovers) {
  for (const int side : {4, 20}) {
    const auto good = net_matrix({.nodes_per_side = side});
    auto bad = net_matrix({.nodes_per_side = side});
    bad.matrix->add_diagonal(Vector::Constant(side * side, 1.0), -600.0);
    Cholesky solver;
    EXPECT_EQ(solver.factor(*bad.matrix), FactorStatus::not_positive_definite);
    EXPECT_FALSE(solver.negative_pivots().has_value());
    Vector x(3 * side * side);
    EXPECT_FALSE(solver.solve(Vector::Ones(x.size()), x, 0).ok);
    EXPECT_EQ(solver.factor(*good.matrix), FactorStatus::ok);
    EXPECT_EQ(solver.negative_pivots(), 0);
    EXPECT_EQ(solver.factor(*bad.matrix), FactorStatus::not_positive_definite);
    expect_solves(solver, *good.matrix, 0, 1e-9);
  }
}

TEST(Cholesky, TakesTheSymmetricPartOfADiagonalBlock) {
  auto model = random_matrix(10, Symmetry::symmetric, 4);
  model.matrix->lower(model.structure->diagonal(3))(0, 2) += 0.2;
  Cholesky solver;
  expect_solves(solver, *model.matrix, 0, 1e-9);  // the dense matrix has it too
}

TEST(Cholesky, ReportsASolutionThatIsNotFinite) {
  const auto model = random_matrix(10, Symmetry::symmetric, 5);
  Cholesky solver;
  ASSERT_EQ(solver.factor(*model.matrix), FactorStatus::ok);
  Vector b = Vector::Ones(30);
  b[4] = std::numeric_limits<double>::quiet_NaN();
  Vector x(30);
  EXPECT_FALSE(solver.solve(b, x, 0).ok);
}

TEST(Cholesky, RefusesUnsymmetricMatricesAndForeignStructures) {
  Cholesky solver;
  const auto unsymmetric = random_matrix(10, Symmetry::unsymmetric, 6);
  EXPECT_THROW((void)solver.factor(*unsymmetric.matrix), std::invalid_argument);
  const auto model = random_matrix(10, Symmetry::symmetric, 6);
  const auto other = random_matrix(11, Symmetry::symmetric, 6);
  solver.analyse(*model.structure);
  EXPECT_THROW((void)solver.factor(*other.matrix), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

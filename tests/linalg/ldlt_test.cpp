#include "sundrape/linalg/ldlt.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "solver_checks.hpp"

namespace sundrape {
namespace {

/// Of the symmetric part.
int negative_eigenvalues_of_dense(const BlockMatrix& matrix) {
  const Eigen::MatrixXd dense = matrix.dense();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (dense + dense.transpose()),
                                                              Eigen::EigenvaluesOnly);
  return static_cast<int>((solver.eigenvalues().array() < 0).count());
}

TEST(Ldlt, CountsTheNegativeEigenvaluesOfShiftedMatrices) {
  for (const auto symmetry : {Symmetry::symmetric, Symmetry::unsymmetric}) {
    const auto model = random_matrix(30, symmetry, 1);
    Ldlt ldlt;
    ldlt.analyse(*model.structure);
    int previous = -1;
    for (int step = 0; step < 5; ++step) {
      const int expected = negative_eigenvalues_of_dense(*model.matrix);
      EXPECT_GT(expected, previous);  // every shift must bring new ones, or this shows little
      ASSERT_EQ(ldlt.factor(*model.matrix), FactorStatus::ok);
      EXPECT_EQ(ldlt.negative_pivots(), expected);
      EXPECT_EQ(negative_eigenvalues(*model.matrix), expected);
      previous = expected;
      model.matrix->add_diagonal(Vector::Ones(30), -0.5);
    }
  }
}

TEST(Ldlt, CompressedNetHasAsManyBucklingModesAsItsDenseMatrix) {
  const auto net = net_matrix({.nodes_per_side = 12, .rate = 10, .tension = -0.02});
  const int expected = negative_eigenvalues_of_dense(*net.matrix);
  ASSERT_GT(expected, 0);
  EXPECT_EQ(negative_eigenvalues(*net.matrix), expected);
}

TEST(Ldlt, SolvesDefiniteAndIndefiniteSystems) {
  Ldlt ldlt;
  expect_solves_definite_systems(ldlt);
  const auto net = net_matrix({.nodes_per_side = 12, .rate = 10, .tension = -0.02});
  ldlt.analyse(*net.structure);
  expect_solves(ldlt, *net.matrix, 1e-10, 1e-6);
  EXPECT_GT(ldlt.negative_pivots().value_or(0), 0);
}

TEST(Ldlt, RefusesASolutionThatItsFactorCannotGive) {
  // [[0, 1], [1, 0]] with a first pivot of 1e-20: without pivoting nothing is left of the second row
  const auto structure = Pattern({0}).build().structure;
  BlockMatrix matrix(structure, Symmetry::symmetric);
  matrix.lower(0) << 1e-20, 1, 0, 1, 1, 0, 0, 0, 1;
  Ldlt ldlt;
  ASSERT_EQ(ldlt.factor(matrix), FactorStatus::ok);
  Vector x(3);
  const auto report = ldlt.solve(Vector3(1, 2, 3), x, 1e-10);
  if (report.ok) {
    EXPECT_LT((matrix.dense() * x - Vector3(1, 2, 3)).norm(), 1e-8);
  }
  matrix.set_zero();
  ASSERT_EQ(ldlt.factor(matrix), FactorStatus::singular);
  EXPECT_FALSE(ldlt.solve(Vector3(1, 2, 3), x, 1e-10).ok);
}

TEST(Ldlt, TellsNothingWhereThePivotIsZeroOrNotFinite) {
  const auto structure = Pattern({0}).build().structure;
  BlockMatrix matrix(structure, Symmetry::symmetric);
  EXPECT_EQ(negative_eigenvalues(matrix), std::nullopt);
  matrix.add_diagonal(Vector::Ones(1), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(negative_eigenvalues(matrix), std::nullopt);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/linalg/inertia.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "support/model_matrices.hpp"

namespace sundrape {
namespace {

/// Of the symmetric part.
int negative_eigenvalues_of_dense(const BlockMatrix& matrix) {
  const Eigen::MatrixXd dense = matrix.dense();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (dense + dense.transpose()),
                                                              Eigen::EigenvaluesOnly);
  return static_cast<int>((solver.eigenvalues().array() < 0).count());
}

TEST(Inertia, CountsTheNegativeEigenvaluesOfShiftedMatrices) {
  for (const auto symmetry : {Symmetry::symmetric, Symmetry::unsymmetric}) {
    const auto model = random_matrix(30, symmetry, 1);
    Inertia inertia(*model.structure);
    int previous = -1;
    for (int step = 0; step < 5; ++step) {
      const int expected = negative_eigenvalues_of_dense(*model.matrix);
      EXPECT_GT(expected, previous);  // every shift must bring new ones, or this shows little
      EXPECT_EQ(inertia.negative_eigenvalues(*model.matrix), expected);
      EXPECT_EQ(negative_eigenvalues(*model.matrix), expected);
      previous = expected;
      model.matrix->add_diagonal(Vector::Ones(30), -0.5);
    }
  }
}

TEST(Inertia, CompressedNetHasAsManyBucklingModesAsItsDenseMatrix) {
  const auto net = net_matrix({.nodes_per_side = 12, .rate = 10, .tension = -0.02});
  const int expected = negative_eigenvalues_of_dense(*net.matrix);
  ASSERT_GT(expected, 0);
  EXPECT_EQ(negative_eigenvalues(*net.matrix), expected);
}

TEST(Inertia, TellsNothingWhereThePivotIsZeroOrNotFinite) {
  const auto structure = Pattern({0}).build().structure;
  BlockMatrix matrix(structure, Symmetry::symmetric);
  EXPECT_EQ(negative_eigenvalues(matrix), std::nullopt);
  matrix.add_diagonal(Vector::Ones(1), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(negative_eigenvalues(matrix), std::nullopt);
}

}  // namespace
}  // namespace sundrape

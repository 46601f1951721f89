#pragma once
#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "sundrape/linalg/linear_solver.hpp"

#include "support/model_matrices.hpp"

namespace sundrape {

/// Factors a matrix, solves for a random right side and holds the answer against a dense solution.
inline void expect_solves(LinearSolver& solver, const BlockMatrix& matrix, double tolerance, double relative_error) {
  ASSERT_EQ(solver.factor(matrix), FactorStatus::ok);
  const Vector b = random_vector(3 * matrix.size(), 99);
  Vector x = Vector::Constant(b.size(), 1e9);  // no starting guess
  const auto report = solver.solve(b, x, tolerance);
  EXPECT_TRUE(report.ok) << report.problem;
  EXPECT_TRUE(report.problem.empty());
  const auto dense = matrix.dense();
  const Vector expected = dense.partialPivLu().solve(b);
  EXPECT_LT((x - expected).norm(), relative_error * expected.norm());
  EXPECT_LT((b - dense * x).norm(), std::max(tolerance, 1e-11) * b.norm());
}

/// Solves for several random right sides at once, one of them zero, and holds each residual against the tolerance.
inline void expect_solves_all(LinearSolver& solver, const BlockMatrix& matrix, Eigen::Index columns, double tolerance) {
  ASSERT_EQ(solver.factor(matrix), FactorStatus::ok);
  Eigen::MatrixXd b =
      random_vector(3 * matrix.size() * static_cast<int>(columns), 98).reshaped(3 * matrix.size(), columns);
  for (Eigen::Index j = 0; j < columns; ++j) b.col(j) *= std::pow(1e3, static_cast<double>(j));  // scales of their own
  if (columns > 2) b.col(1).setZero();
  Eigen::MatrixXd x;
  const auto report = solver.solve_all(b, x, tolerance);
  EXPECT_TRUE(report.ok) << report.problem;
  ASSERT_EQ(x.cols(), columns);
  const auto dense = matrix.dense();
  for (Eigen::Index j = 0; j < columns; ++j)
    EXPECT_LE((b.col(j) - dense * x.col(j)).norm(), std::max(tolerance, 1e-11) * b.col(j).norm()) << j;
}

/// What every direct or tight iterative solver must do with symmetric positive definite matrices.
inline void expect_solves_definite_systems(LinearSolver& solver) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto model = random_matrix(40, Symmetry::symmetric, seed);
    solver.analyse(*model.structure);
    expect_solves(solver, *model.matrix, 1e-10, 1e-7);
    model.matrix->hold(7, 1, 3.0);  // new values on the same structure
    model.matrix->hold(0, 0, 3.0);
    model.matrix->add_diagonal(Vector::Constant(40, 1.0), 0.5);
    expect_solves(solver, *model.matrix, 1e-10, 1e-7);
  }
  const auto net = net_matrix({.nodes_per_side = 12, .rate = 100});
  solver.analyse(*net.structure);
  expect_solves(solver, *net.matrix, 1e-10, 1e-6);
}

}  // namespace sundrape

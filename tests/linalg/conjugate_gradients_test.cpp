#include "sundrape/linalg/conjugate_gradients.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "solver_checks.hpp"

namespace sundrape {
namespace {

TEST(ConjugateGradients, SolvesDefiniteSystemsTightly) {
  ConjugateGradients solver;
  expect_solves_definite_systems(solver);
}

TEST(ConjugateGradients, ReachesTheToleranceAskedForInTheTrueResidual) {
  const auto net = net_matrix({.nodes_per_side = 21, .rate = 300});
  ConjugateGradients solver;
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
  const Vector b = random_vector(3 * net.matrix->size(), 1);
  Vector x(b.size());
  Vector product(b.size());
  int previous = 0;
  for (const double tolerance : {1e-1, 1e-2, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
    const auto report = solver.solve(b, x, tolerance);
    EXPECT_TRUE(report.ok) << tolerance << ": " << report.problem;
    net.matrix->multiply(x, product);
    EXPECT_LE((b - product).norm(), 1.0001 * tolerance * b.norm());
    EXPECT_GE(report.iterations, previous);
    previous = report.iterations;
  }
}

TEST(ConjugateGradients, SolvesForSeveralRightSidesAtOnce) {
  const auto net = net_matrix({.nodes_per_side = 21, .rate = 300});
  for (const Eigen::Index columns : {1, 2, 3, 4, 7})
    for (const double tolerance : {1e-1, 1e-3, 1e-6}) {
      ConjugateGradients solver;
      solver.analyse(*net.structure);
      expect_solves_all(solver, *net.matrix, columns, tolerance);
    }
}

TEST(ConjugateGradients, SaysWhyOneOfSeveralRightSidesFailed) {
  const auto net = net_matrix({.nodes_per_side = 21, .rate = 60});
  ConjugateGradients solver(nullptr, 3);
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(3 * net.matrix->size(), 3), x;
  EXPECT_TRUE(solver.solve_all(b, x, 1e-2).ok);
  b.col(2) = random_vector(3 * net.matrix->size(), 1);
  const auto report = solver.solve_all(b, x, 1e-2);
  EXPECT_FALSE(report.ok);
  EXPECT_EQ(report.problem, solver.solve(b.col(2), x.col(2), 1e-2).problem);
  EXPECT_EQ(report.iterations, 3);
}

TEST(ConjugateGradients, GivesUpOnSolutionsThatAreTooLargeToBeOfUse) {
  const auto net = net_matrix({.nodes_per_side = 21, .rate = 60});
  ConjugateGradients solver;
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
  const Vector b = random_vector(3 * net.matrix->size(), 1);
  Vector x(b.size());
  const auto whole = solver.solve(b, x, 1e-4);
  ASSERT_TRUE(whole.ok);
  const double size = x.norm();
  const auto refused = solver.solve(b, x, 1e-4, 0.5 * size);
  EXPECT_FALSE(refused.ok);
  EXPECT_LT(refused.iterations, whole.iterations);
  EXPECT_GT(x.norm(), 0.5 * size);
  const auto accepted = solver.solve(b, x, 1e-4, 1.1 * size);
  EXPECT_TRUE(accepted.ok) << accepted.problem;
  EXPECT_EQ(accepted.iterations, whole.iterations);
}

TEST(ConjugateGradients, DoesNotCareForTheUnitsOfMatrixAndRightSide) {
  for (const double units : {1e-30, 1.0, 1e30}) {
    auto net = net_matrix({.nodes_per_side = 8});
    for (std::int64_t k = 0; k < net.structure->blocks(); ++k) net.matrix->lower(k) *= units;
    ConjugateGradients solver;
    ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
    const Vector b = 1e-25 * random_vector(192, 1);
    Vector x(192);
    ASSERT_TRUE(solver.solve(b, x, 1e-3).ok);
    EXPECT_LT((b - net.matrix->dense() * x).norm(), 1e-3 * b.norm());
  }
}

// The published count for a moving 81² tablecloth is 11 to 16 iterations; a right side as rough as this takes more.
TEST(ConjugateGradients, NeedsFewIterationsWhereTheMassDominates) {
  const auto net = net_matrix({.nodes_per_side = 41, .rate = 600});
  ConjugateGradients solver;
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
  const Vector b = random_vector(3 * net.matrix->size(), 1);
  Vector x(b.size());
  const auto report = solver.solve(b, x, 1e-2);
  EXPECT_TRUE(report.ok);
  EXPECT_LE(report.iterations, 16);
}

TEST(ConjugateGradients, ReportsNegativeCurvatureOfAnIndefiniteMatrix) {
  auto net = net_matrix({.nodes_per_side = 15});
  net.matrix->add_diagonal(Vector::Ones(225), -50.0);
  ConjugateGradients solver;
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);  // the shifted preconditioner exists
  const Vector b = random_vector(675, 1);
  Vector x(675);
  for (const double tolerance : {1e-3, 1e-8}) {
    const auto report = solver.solve(b, x, tolerance);
    EXPECT_FALSE(report.ok);
    EXPECT_NE(report.problem.find("negative curvature"), std::string::npos) << report.problem;
    EXPECT_TRUE(x.allFinite());
  }
}

TEST(ConjugateGradients, ReportsTooManyIterations) {
  const auto net = net_matrix({.nodes_per_side = 21, .rate = 10});
  ConjugateGradients solver(nullptr, 5);
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
  const Vector b = random_vector(3 * net.matrix->size(), 1);
  Vector x(b.size());
  for (const double tolerance : {1e-3, 1e-8}) {
    const auto report = solver.solve(b, x, tolerance);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(report.iterations, 5);
    EXPECT_NE(report.problem.find("within 5 iterations"), std::string::npos) << report.problem;
  }
}

TEST(ConjugateGradients, AnswersANothingWithNothing) {
  const auto net = net_matrix({.nodes_per_side = 5});
  ConjugateGradients solver;
  Vector x = Vector::Ones(75);
  EXPECT_FALSE(solver.solve(x, x, 1e-2).ok);  // nothing factored yet
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
  x.setOnes();
  EXPECT_TRUE(solver.solve(Vector::Zero(75), x, 1e-2).ok);
  EXPECT_EQ(x.norm(), 0);
}

TEST(ConjugateGradients, RefusesWhatIsNotFinite) {
  auto net = net_matrix({.nodes_per_side = 5});
  ConjugateGradients solver;
  ASSERT_EQ(solver.factor(*net.matrix), FactorStatus::ok);
  Vector b = Vector::Ones(75);
  b[3] = std::numeric_limits<double>::infinity();
  Vector x(75);
  EXPECT_FALSE(solver.solve(b, x, 1e-2).ok);
  net.matrix->lower(0)(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solver.factor(*net.matrix), FactorStatus::not_positive_definite);
}

TEST(ConjugateGradients, RefusesUnsymmetricMatricesAndForeignStructures) {
  ConjugateGradients solver;
  const auto unsymmetric = random_matrix(10, Symmetry::unsymmetric, 6);
  EXPECT_THROW((void)solver.factor(*unsymmetric.matrix), std::invalid_argument);
  const auto other = random_matrix(11, Symmetry::symmetric, 6);
  EXPECT_THROW((void)solver.factor(*other.matrix), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

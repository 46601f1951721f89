#include "sundrape/linalg/lu.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "solver_checks.hpp"

namespace sundrape {
namespace {

TEST(Lu, SolvesDefiniteSystems) {
  Lu solver;
  expect_solves_definite_systems(solver);
}

TEST(Lu, SolvesUnsymmetricSystems) {
  Lu solver;
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto model = random_matrix(40, Symmetry::unsymmetric, seed);
    ASSERT_GT(model.matrix->asymmetry(), 0.1);
    solver.analyse(*model.structure);
    expect_solves(solver, *model.matrix, 0, 1e-7);
    model.matrix->hold(7, 1, 3.0);
    model.matrix->add_diagonal(Vector::Constant(40, 1.0), 0.5);
    expect_solves(solver, *model.matrix, 0, 1e-7);
  }
}

TEST(Lu, SolvesIndefiniteSystems) {
  auto net = net_matrix({.nodes_per_side = 10});
  net.matrix->add_diagonal(Vector::Constant(100, 1.0), -50.0);
  Lu solver;
  expect_solves(solver, *net.matrix, 0, 1e-8);
}

// One block [[ε, 1, 0], [1, ε, 0], [0, 0, 1]]: pivots chosen for ε = 1000 sit on the diagonal and are worthless later.
TEST(Lu, ChoosesNewPivotsWhenTheOldOnesNoLongerServe) {
  const auto structure = Pattern({0}).build().structure;
  BlockMatrix matrix(structure, Symmetry::unsymmetric);
  Lu solver;
  for (const double small : {1e3, 1e-14, 0.0}) {
    matrix.lower(0) << small, 1, 0, 1, small, 0, 0, 0, 1;
    expect_solves(solver, matrix, 0, 1e-12);
  }
}

TEST(Lu, ReportsASingularMatrixAndRecovers) {
  const auto model = random_matrix(10, Symmetry::unsymmetric, 3);
  auto singular = random_matrix(10, Symmetry::unsymmetric, 3);
  singular.matrix->hold(4, 1, 0.0);
  Lu solver;
  EXPECT_EQ(solver.factor(*singular.matrix), FactorStatus::singular);
  Vector x(30);
  EXPECT_FALSE(solver.solve(Vector::Ones(30), x, 0).ok);
  expect_solves(solver, *model.matrix, 0, 1e-8);
  EXPECT_EQ(solver.factor(*singular.matrix), FactorStatus::singular);
}

TEST(Lu, RefusesForeignStructures) {
  Lu solver;
  const auto model = random_matrix(10, Symmetry::symmetric, 6);
  const auto other = random_matrix(11, Symmetry::symmetric, 6);
  solver.analyse(*model.structure);
  EXPECT_THROW((void)solver.factor(*other.matrix), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

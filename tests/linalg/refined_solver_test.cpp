#include "sundrape/linalg/refined_solver.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sundrape/linalg/lu.hpp"

#include "solver_checks.hpp"

namespace sundrape {
namespace {

/// Counts how often the symmetric solver is asked; may say that it cannot.
class Inner final : public LinearSolver {
 public:
  Inner(int& solves, bool willing)
      : solver_(make_linear_solver(SolverKind::cholesky)), solves_(solves), willing_(willing) {}
  [[nodiscard]] std::string_view name() const override { return "inner"; }
  [[nodiscard]] Symmetry symmetry() const override { return Symmetry::symmetric; }
  void analyse(const BlockStructure& structure) override { solver_->analyse(structure); }
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override {
    return willing_ ? solver_->factor(matrix) : FactorStatus::not_positive_definite;
  }
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance, double largest) override {
    ++solves_;
    return solver_->solve(b, x, tolerance, largest);
  }

 private:
  std::unique_ptr<LinearSolver> solver_;
  int& solves_;
  bool willing_;
};

TEST(RefinedSolver, SolvesUnsymmetricSystemsByASolverOfSymmetricOnes) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto model = random_matrix(40, Symmetry::unsymmetric, seed);
    model.matrix->add_diagonal(Vector::Constant(40, 1.0), 20);  // the skew part counts for less
    int solves = 0;
    RefinedSolver solver(std::make_unique<Inner>(solves, true));
    solver.analyse(*model.structure);
    expect_solves(solver, *model.matrix, 1e-10, 1e-8);
    EXPECT_GT(solves, 1);
    EXPECT_LE(solves, 20);
  }
}

TEST(RefinedSolver, GoesWithConjugateGradientsToo) {
  const auto model = random_matrix(40, Symmetry::unsymmetric, 4);
  model.matrix->add_diagonal(Vector::Constant(40, 1.0), 20);
  RefinedSolver solver(make_linear_solver(SolverKind::conjugate_gradients));
  solver.analyse(*model.structure);
  expect_solves(solver, *model.matrix, 1e-8, 1e-6);
}

TEST(RefinedSolver, SolvesForSeveralRightSidesAtOnce) {
  const auto model = random_matrix(40, Symmetry::unsymmetric, 4);
  model.matrix->add_diagonal(Vector::Constant(40, 1.0), 20);
  for (const auto kind : {SolverKind::conjugate_gradients, SolverKind::cholesky})
    for (const Eigen::Index columns : {1, 3, 6}) {
      RefinedSolver solver(make_linear_solver(kind));
      solver.analyse(*model.structure);
      expect_solves_all(solver, *model.matrix, columns, 1e-8);
    }
}

TEST(RefinedSolver, LeavesToLuWhatTheOtherSolverCannotDo) {
  const auto model = random_matrix(40, Symmetry::unsymmetric, 5);
  int solves = 0;
  RefinedSolver solver(std::make_unique<Inner>(solves, false));
  solver.analyse(*model.structure);
  expect_solves(solver, *model.matrix, 1e-10, 1e-7);
  EXPECT_EQ(solves, 0);
}

TEST(RefinedSolver, RefusesASolverOfUnsymmetricSystems) {
  EXPECT_THROW(RefinedSolver(std::make_unique<Lu>()), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

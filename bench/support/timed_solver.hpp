#pragma once
#include <memory>
#include <utility>

#include "sundrape/linalg/linear_solver.hpp"

#include "support/cpu_clock.hpp"

namespace sundrape {

/// Another solver, with the processor time that its factorisations and solves take added to sums that outlive it.
class TimedSolver final : public LinearSolver {
 public:
  struct Seconds {
    double factor = 0, solve = 0;
  };

  TimedSolver(std::unique_ptr<LinearSolver> solver, Seconds& seconds) : solver_(std::move(solver)), seconds_(seconds) {}

  [[nodiscard]] std::string_view name() const override { return solver_->name(); }
  [[nodiscard]] Symmetry symmetry() const override { return solver_->symmetry(); }
  void analyse(const BlockStructure& structure) override { solver_->analyse(structure); }
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override {
    const CpuClock clock;
    const auto status = solver_->factor(matrix);
    seconds_.factor += clock.seconds();
    return status;
  }
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance, double largest) override {
    const CpuClock clock;
    auto report = solver_->solve(b, x, tolerance, largest);
    seconds_.solve += clock.seconds();
    return report;
  }
  [[nodiscard]] std::optional<int> negative_pivots() const override { return solver_->negative_pivots(); }

 private:
  std::unique_ptr<LinearSolver> solver_;
  Seconds& seconds_;
};

}  // namespace sundrape

#pragma once
#include <memory>

#include "sundrape/linalg/linear_solver.hpp"

namespace sundrape {

/// An iterative solver as long as it is quick, a direct one from there on.
///
/// For matrices M/h² + K whose h grows: while mass dominates a few iterations do; as it fades they become many, and the
/// system at which the iterative solver gives up goes to the direct one, as do those after it. An indefinite matrix
/// shows that h has grown too far: mass is about to dominate again, so the iterative solver gets the next one.
class TurningSolver final : public LinearSolver {
 public:
  /// @param iterative  gives up after as many iterations as it is worth
  /// @throws std::invalid_argument  solvers that want different matrices
  TurningSolver(std::unique_ptr<LinearSolver> iterative, std::unique_ptr<LinearSolver> direct);

  [[nodiscard]] std::string_view name() const override { return "iterative, then direct"; }
  [[nodiscard]] Symmetry symmetry() const override { return direct_->symmetry(); }
  void analyse(const BlockStructure& structure) override;
  /// Keeps a reference to the matrix.
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override;
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance,
                                  double largest = std::numeric_limits<double>::infinity()) override;

 private:
  FactorStatus factor_directly(const BlockMatrix& matrix);

  std::unique_ptr<LinearSolver> iterative_, direct_;
  const BlockStructure* structure_ = nullptr;  // as long as the direct solver has not analysed it
  const BlockMatrix* matrix_ = nullptr;
  bool is_direct_ = false;
};

}  // namespace sundrape

#pragma once
#include <memory>
#include <optional>

#include "sundrape/linalg/linear_solver.hpp"

namespace sundrape {

/// Solves unsymmetric systems that are nearly symmetric, to any accuracy, by a solver of symmetric ones.
///
/// The symmetric part is what the other solver gets, with few digits asked for; its answers precondition flexible GMRES
/// on the whole system (Saad 1993). Where that does not converge quickly the whole matrix goes to LU.
class RefinedSolver final : public LinearSolver {
 public:
  /// @param symmetric  for the symmetric part
  /// @throws std::invalid_argument  a solver that wants an unsymmetric matrix
  explicit RefinedSolver(std::unique_ptr<LinearSolver> symmetric);

  [[nodiscard]] std::string_view name() const override { return "refined"; }
  [[nodiscard]] Symmetry symmetry() const override { return Symmetry::unsymmetric; }
  void analyse(const BlockStructure& structure) override;
  /// Keeps a reference to the matrix.
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override;
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance,
                                  double largest = std::numeric_limits<double>::infinity()) override;
  [[nodiscard]] SolveReport solve_all(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance) override;

 private:
  class Course;
  [[nodiscard]] FactorStatus factor_directly();
  [[nodiscard]] bool iterate(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance, SolveReport& report);

  std::unique_ptr<LinearSolver> symmetric_, direct_;
  const BlockStructure* structure_ = nullptr;
  const BlockMatrix* matrix_ = nullptr;
  std::optional<BlockMatrix> part_;  // the symmetric one
  bool is_direct_ = false;           // of the matrix at hand
};

}  // namespace sundrape

#pragma once
#include <memory>

#include "sundrape/linalg/linear_solver.hpp"
#include "sundrape/linalg/preconditioner.hpp"

namespace sundrape {

/// Preconditioned conjugate gradients (Hestenes, Stiefel 1952) for symmetric positive definite systems.
///
/// Works in single precision as long as the tolerance allows it, and takes over in double where it does not, where the
/// true residual turns out larger than the recursion said, or where single precision saw negative curvature. The
/// preconditioner is in single precision always.
///
/// solve() reports failure on negative curvature (the matrix is indefinite) and after too many iterations; x is then
/// the iterate reached. factor() and solve() throw std::invalid_argument for a matrix that is not stored as a symmetric
/// one or has another structure than the one analysed.
class ConjugateGradients final : public LinearSolver {
 public:
  /// By default preconditioned with a modified block incomplete Cholesky factorisation.
  explicit ConjugateGradients(std::unique_ptr<Preconditioner> preconditioner = nullptr, int max_iterations = 500);

  [[nodiscard]] std::string_view name() const override { return "conjugate gradients"; }
  [[nodiscard]] Symmetry symmetry() const override { return Symmetry::symmetric; }
  void analyse(const BlockStructure& structure) override;
  /// Keeps a reference to the matrix.
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override;
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance,
                                  double largest = std::numeric_limits<double>::infinity()) override;
  /// Four at a time in single precision where the tolerance allows it.
  [[nodiscard]] SolveReport solve_all(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance) override;

 private:
  template <std::size_t m>
  [[nodiscard]] SolveReport solve_together(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x,
                                           double tolerance, int iterations);

  std::unique_ptr<Preconditioner> preconditioner_;
  int max_iterations_;
  std::optional<PaddedMatrix> padded_;
  const BlockMatrix* matrix_ = nullptr;
};

}  // namespace sundrape

#pragma once
#include <memory>

#include "sundrape/linalg/linear_solver.hpp"

namespace sundrape {

class SymmetricFactor;

/// Symmetric systems of any signature by P A Pᵀ = L D Lᵀ, with the number of negative eigenvalues read off the signs of
/// D (Sylvester's law of inertia). Of an unsymmetric matrix it takes the symmetric part (A + Aᵀ)/2.
///
/// D is diagonal and there is no pivoting, so that a small pivot may cost digits or break the factorisation down:
/// solve() refines its solution by the matrix and reports a failure where its backward error stays large.
class Ldlt final : public LinearSolver {
 public:
  Ldlt();
  ~Ldlt() override;

  [[nodiscard]] std::string_view name() const override;
  [[nodiscard]] Symmetry symmetry() const override { return Symmetry::symmetric; }
  void analyse(const BlockStructure& structure) override;
  /// `singular` where a pivot is zero or not finite.
  /// @throws std::invalid_argument  a matrix of another structure than the one analysed
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override;
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance,
                                  double largest = std::numeric_limits<double>::infinity()) override;
  [[nodiscard]] std::optional<int> negative_pivots() const override;

 private:
  std::unique_ptr<SymmetricFactor> factor_;
  const BlockMatrix* matrix_ = nullptr;  // last factored, for refinement
};

/// Negative eigenvalues of a single matrix, or of the symmetric part of an unsymmetric one; nothing where the
/// factorisation broke down.
[[nodiscard]] std::optional<int> negative_eigenvalues(const BlockMatrix& matrix);

}  // namespace sundrape

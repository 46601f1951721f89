#pragma once
#include <memory>

#include "sundrape/linalg/linear_solver.hpp"

namespace sundrape {

class SymmetricFactor;

/// Direct solution of a symmetric positive definite system by its sparse factor P A Pᵀ = L Lᵀ, ordered by minimum
/// degree: CHOLMOD's supernodal factorisation (Chen, Davis, Hager, Rajamanickam 2008), or, in a build without CHOLMOD,
/// Eigen's simplicial L D Lᵀ.
///
/// factor() finds an indefinite matrix out and reports it; it throws std::invalid_argument for a matrix that is not
/// stored as a symmetric one or has another structure than the one analysed.
class Cholesky final : public LinearSolver {
 public:
  Cholesky();
  ~Cholesky() override;

  [[nodiscard]] std::string_view name() const override;
  [[nodiscard]] Symmetry symmetry() const override { return Symmetry::symmetric; }
  void analyse(const BlockStructure& structure) override;
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override;
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance,
                                  double largest = std::numeric_limits<double>::infinity()) override;
  [[nodiscard]] std::optional<int> negative_pivots() const override;

 private:
  std::unique_ptr<SymmetricFactor> factor_;
};

}  // namespace sundrape

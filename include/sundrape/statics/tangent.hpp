#pragma once
#include <memory>
#include <optional>

#include "sundrape/linalg/linear_solver.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape {

/// The tangent stiffness K = −∂f/∂q of a system (25) at one state after another, factored whatever its signature.
///
/// K + ε² M is what is factored, with ε [1/s] far below the slowest frequency of interest: it tells neutral motion (a
/// sheet that slides freely) from instability. Where K is symmetric a Cholesky factorisation is tried first, and L D Lᵀ
/// where that finds it indefinite; an unsymmetric K goes to LU, and the pivots are those of its symmetric part.
class Tangent {
 public:
  Tangent(const System& system, double neutral_frequency);

  /// Assembles and factors at a state of all points; rates do not count.
  [[nodiscard]] FactorStatus factor(const State& all);
  /// x = K⁻¹ b, rows, 3n; may not overlap.
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x) { return used_->solve(b, x, 1e-10); }
  /// The same without ε: by the factor, and what it leaves corrected by itself. What is neutral has no part in b.
  [[nodiscard]] SolveReport solve_stiffness(ConstVectorRef b, VectorRef x);
  /// Negative pivots of the last K factored: independent ways in which an equilibrium there is unstable. Nothing if
  /// that cannot be told.
  [[nodiscard]] std::optional<int> negative_pivots();

  /// Which part of the resistance to a motion of the rows, x·(K + ε² M)x, is none of K's: near 1 where nothing resists.
  [[nodiscard]] double neutral_part(const Vector& x) const;

  [[nodiscard]] const BlockMatrix& matrix() const { return matrix_; }
  [[nodiscard]] long factorizations() const { return factorizations_; }

 private:
  [[nodiscard]] FactorStatus factor_symmetric();

  const System& system_;
  Vector shift_;  // ε² times the masses, n
  Vector still_;  // 3P
  BlockMatrix matrix_;
  long of_structure_;                                   // that the matrix is for
  std::unique_ptr<LinearSolver> cholesky_, ldlt_, lu_;  // lu_ where K is unsymmetric, cholesky_ where not
  LinearSolver* used_ = nullptr;
  bool was_indefinite_ = false, ldlt_current_ = false;
  long factorizations_ = 0;
};

}  // namespace sundrape

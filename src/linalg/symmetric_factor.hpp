#pragma once
#include <memory>
#include <optional>

#include "sundrape/linalg/block_matrix.hpp"
#include "sundrape/linalg/compressed_columns.hpp"
#include "sundrape/linalg/linear_solver.hpp"

namespace sundrape {

/// The sparse factor of symmetric matrices on one structure, in minimum-degree order: CHOLMOD's, or Eigen's L D Lᵀ in a
/// build without CHOLMOD.
class SymmetricFactor {
 public:
  enum class Kind {
    definite,   // L Lᵀ, supernodal where that pays; notices an indefinite matrix
    indefinite  // L D Lᵀ with a diagonal D and without pivoting
  };
  explicit SymmetricFactor(Kind kind);
  ~SymmetricFactor();

  void analyse(const BlockStructure& structure);
  /// Analyses the structure first if there was none. An indefinite factor reports what is not positive definite in
  /// negative_pivots(), and `singular` where a pivot is zero or not finite.
  /// @throws std::invalid_argument  a matrix of another structure than the one analysed
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix);
  /// x = A⁻¹ b with the last factor; false where there is none, or the triangular solves failed.
  [[nodiscard]] bool solve(ConstVectorRef b, VectorRef x);
  /// Negative eigenvalues of the last matrix (Sylvester's law of inertia); nothing where it could not be factored.
  [[nodiscard]] std::optional<int> negative_pivots() const { return negative_pivots_; }
  /// Largest |entry| of the last matrix.
  [[nodiscard]] double largest_entry();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  std::optional<CompressedColumns> columns_;
  std::optional<int> negative_pivots_;
};

}  // namespace sundrape

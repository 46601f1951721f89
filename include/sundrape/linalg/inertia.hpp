#pragma once
#include <memory>
#include <optional>

#include "sundrape/linalg/block_matrix.hpp"

namespace sundrape {

/// Counts the negative eigenvalues of symmetric matrices on one structure by the signs of D in P A Pᵀ = L D Lᵀ
/// (Sylvester's law of inertia). Of an unsymmetric matrix it counts those of the symmetric part (A + Aᵀ)/2.
///
/// D is diagonal and there is no pivoting: a tangent at a bifurcation may break the factorisation down.
class Inertia {
 public:
  explicit Inertia(const BlockStructure& structure);  // the symbolic analysis
  ~Inertia();

  /// Nothing where the factorisation broke down (a pivot of zero, or one that is not finite).
  /// @throws std::invalid_argument  a matrix of another structure
  [[nodiscard]] std::optional<int> negative_eigenvalues(const BlockMatrix& matrix);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The same for a single matrix.
[[nodiscard]] std::optional<int> negative_eigenvalues(const BlockMatrix& matrix);

}  // namespace sundrape

#pragma once
#include "sundrape/linalg/padded_matrix.hpp"

namespace sundrape {

/// An approximate inverse of symmetric positive definite matrices on one structure, for conjugate gradients: itself
/// symmetric and positive definite.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// Once a structure, which must live as long as it is used.
  virtual void analyse(const BlockStructure& structure) = 0;
  /// Once a matrix. False if none could be built: the matrix is far from positive definite.
  [[nodiscard]] virtual bool build(const PaddedMatrix& matrix) = 0;
  /// z ≈ A⁻¹ r with the A of the last build. r, z: 4n, may be the same.
  virtual void apply(ConstPaddedRef r, PaddedRef z) const = 0;
  /// The same for m vectors side by side, at most PaddedMatrix::together. r, z: 4mn, may be the same.
  virtual void apply_together(ConstPaddedRef r, PaddedRef z) const = 0;
};

}  // namespace sundrape

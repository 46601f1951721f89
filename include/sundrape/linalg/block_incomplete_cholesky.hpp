#pragma once
#include <cstdint>
#include <vector>

#include "sundrape/linalg/preconditioner.hpp"

namespace sundrape {

/// Modified block incomplete factorisation without fill, A ≈ (I + L) D (I + Lᵀ) on the 3×3 blocks of A's own structure
/// in its natural ordering (Meijerink, van der Vorst 1977; modified as by Gustafsson 1978: the fill that is dropped at
/// (i, j) goes, times `modification`, to the diagonal blocks i and j).
///
/// Where a diagonal block loses its definiteness, the diagonal is shifted and the factorisation begins again. The shift
/// of one matrix is where the next one starts, halved.
class BlockIncompleteCholesky final : public Preconditioner {
 public:
  /// @param modification  in [0, 1]; 0: plain incomplete Cholesky, 1: rows of the dropped fill sum to zero
  /// @throws std::invalid_argument  out of range
  explicit BlockIncompleteCholesky(double modification = 0.95);

  void analyse(const BlockStructure& structure) override;
  [[nodiscard]] bool build(const PaddedMatrix& matrix) override;
  void apply(ConstPaddedRef r, PaddedRef z) const override;
  void apply_together(ConstPaddedRef r, PaddedRef z) const override;

  /// Shift of the last build, relative to each diagonal block's largest entry.
  [[nodiscard]] double shift() const { return shift_; }

 private:
  [[nodiscard]] bool factorise(const PaddedMatrix& matrix);
  [[nodiscard]] bool invert_diagonal(int row);
  void eliminate(int column);
  template <int vectors>
  void apply_to(const float* r, float* z) const;

  double modification_;
  double shift_ = 0;
  const BlockStructure* structure_ = nullptr;
  BlockColumns columns_;
  std::vector<std::int64_t> target_start_;  // by column
  std::vector<std::int64_t> target_;        // block that a pair of a column's blocks updates, −1: dropped
  Eigen::VectorXf blocks_;                  // L below the diagonal, D⁻¹ on it; 12 floats a block
  Eigen::VectorXf unscaled_;                // the column being eliminated, L D; 12 floats a block
  std::vector<float> floor_;                // by row, the least pivot that is taken for positive
};

}  // namespace sundrape

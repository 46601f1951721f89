#pragma once
#include <Eigen/Core>

#include "sundrape/linalg/block_matrix.hpp"

namespace sundrape {

/// Vectors of the single-precision solvers: four floats a block row, the fourth of them 0, so that a block row fills a
/// SIMD register. Shape: 4n.
using PaddedVector = Eigen::VectorXf;
using PaddedRef = Eigen::Ref<PaddedVector>;
using ConstPaddedRef = Eigen::Ref<const PaddedVector>;

/// out = factor · v.  v: 3n, out: 4n.
void pad(ConstVectorRef v, double factor, PaddedRef out);
/// out = factor · v.  v: 4n, out: 3n.
void unpad(ConstPaddedRef v, double factor, VectorRef out);

/// A symmetric block matrix in single precision, scaled to a largest diagonal entry of 1: the float copy that iterative
/// solvers and preconditioners work on. Blocks are 3 columns of 4 floats, the fourth of each being 0.
class PaddedMatrix {
 public:
  static constexpr std::int64_t block_floats = 12;
  /// Most vectors that are worked on side by side: a block is read once for all of them and none waits for another, so
  /// that four take half again as long as one. They lie row by row, m vectors as 4m floats a block row.
  static constexpr int together = 4;

  explicit PaddedMatrix(const BlockStructure& structure);  // keeps a reference to the structure

  /// Takes the values of a symmetric matrix on the same structure.
  void copy(const BlockMatrix& matrix);

  /// The copy is the matrix divided by this.
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] int size() const { return structure_->size(); }
  [[nodiscard]] const BlockStructure& structure() const { return *structure_; }
  [[nodiscard]] const BlockColumns& columns() const { return columns_; }
  [[nodiscard]] const Eigen::VectorXf& blocks() const { return blocks_; }  // 12 a stored block

  /// y = A x. x, y: 4n, may not overlap.
  void multiply(ConstPaddedRef x, PaddedRef y) const;
  /// The same for 1 to `together` vectors side by side. x, y: 4mn, may not overlap.
  void multiply_together(ConstPaddedRef x, PaddedRef y) const;

 private:
  template <int vectors>
  void multiply_each(const float* x, float* y) const;

  const BlockStructure* structure_;
  BlockColumns columns_;
  Eigen::VectorXf blocks_;
  double scale_ = 1;
};

}  // namespace sundrape

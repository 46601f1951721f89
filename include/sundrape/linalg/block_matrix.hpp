#pragma once
#include <optional>
#include <span>
#include <vector>

#include "sundrape/linalg/block_structure.hpp"
#include "sundrape/types.hpp"

namespace sundrape {

enum class Symmetry { symmetric, unsymmetric };

/// A 3n × 3n matrix of 3×3 blocks on a symmetric structure.
///
/// A symmetric matrix stores its lower triangle; an unsymmetric one also stores, beside each lower block (i, j), the
/// upper block (j, i). Blocks are column-major, 9 doubles each; one scratch block follows the last. Of the diagonal
/// blocks of a symmetric matrix the symmetric part counts, here and in every solver.
class BlockMatrix {
 public:
  BlockMatrix(const BlockStructure& structure, Symmetry symmetry);  // keeps a reference to the structure

  [[nodiscard]] const BlockStructure& structure() const { return *structure_; }
  [[nodiscard]] Symmetry symmetry() const { return symmetry_; }
  [[nodiscard]] int size() const { return structure_->size(); }

  void set_zero();
  /// Adds `mass_factor` · mass to the diagonal. mass: one entry a block row.
  /// @throws std::invalid_argument  another number of entries
  void add_diagonal(ConstVectorRef mass, double mass_factor);
  /// Makes row and column of one component those of the unit matrix times `value` (a component that is held).
  void hold(int row, int component, double value);

  [[nodiscard]] Eigen::Map<Matrix3> lower(std::int64_t block) {
    return Eigen::Map<Matrix3>(&lower_[9 * static_cast<std::size_t>(block)]);
  }
  [[nodiscard]] Eigen::Map<const Matrix3> lower(std::int64_t block) const {
    return Eigen::Map<const Matrix3>(&lower_[9 * static_cast<std::size_t>(block)]);
  }
  /// Block (column, row) of the stored block (row, column); unsymmetric matrices only. Unused on the diagonal.
  [[nodiscard]] Eigen::Map<Matrix3> upper(std::int64_t block) {
    return Eigen::Map<Matrix3>(&upper_[9 * static_cast<std::size_t>(block)]);
  }
  [[nodiscard]] Eigen::Map<const Matrix3> upper(std::int64_t block) const {
    return Eigen::Map<const Matrix3>(&upper_[9 * static_cast<std::size_t>(block)]);
  }
  /// Diagonal block of a row: its symmetric part if the matrix is symmetric.
  [[nodiscard]] Matrix3 diagonal(int row) const;
  [[nodiscard]] std::span<const double> lower_values() const { return lower_; }

  /// y = A x. x, y: 3n, may not overlap.
  /// @throws std::invalid_argument  other lengths
  void multiply(ConstVectorRef x, VectorRef y) const;
  /// The same for every column of x, blocks being read once. y is resized.
  void multiply_all(const Eigen::MatrixXd& x, Eigen::MatrixXd& y) const;
  /// Largest |A − Aᵀ| entry over the largest |A| entry; 0 for a symmetric matrix.
  [[nodiscard]] double asymmetry() const;
  /// The whole matrix, dense: for tests and diagnosis.
  [[nodiscard]] Eigen::MatrixXd dense() const;

 private:
  void multiply_symmetric(ConstVectorRef x, VectorRef y) const;

  const BlockStructure* structure_;
  Symmetry symmetry_;
  std::vector<double> lower_, upper_;
  std::optional<BlockColumns> columns_;  // built by the first hold
};

/// Adds the blocks of one term's elements to a matrix, straight into their slots.
class Assembler {
 public:
  Assembler(BlockMatrix& matrix, const SlotTable& table) : matrix_(&matrix), table_(&table) {}

  /// True where blocks without a transposed twin are kept: terms may skip computing them otherwise.
  [[nodiscard]] bool keeps_unsymmetric() const { return matrix_->symmetry() == Symmetry::unsymmetric; }

  /// Block (p, p) of an element; only its symmetric part reaches a symmetric matrix's solvers.
  void add_diagonal(std::size_t element, int p, const Matrix3& block) {
    add(matrix_->lower(table_->at(element, p, p).block).data(), block.data());
  }

  /// Block (p, q) of an element, and its transpose at (q, p); p < q.
  void add_pair(std::size_t element, int p, int q, const Matrix3& block) {
    add_pair_below(element, p, q, block.transpose());
  }

  /// Block (q, p) of an element, and its transpose at (p, q); p < q. Faster than add_pair where the element's points
  /// are mostly ascending, since the lower triangle is stored.
  [[gnu::always_inline]] void add_pair_below(std::size_t element, int p, int q, const Matrix3& block) {
    const Slot slot = table_->at(element, p, q);
    if (slot.transposed && !keeps_unsymmetric()) [[likely]]
      add(matrix_->lower(slot.block).data(), block.data());
    else
      add_pair_to(slot, block);
  }

  /// Blocks (p, q) and (q, p) of an element, p < q. A symmetric matrix takes the mean of block and transpose.
  void add_general_pair(std::size_t element, int p, int q, const Matrix3& pq, const Matrix3& qp) {
    if (!keeps_unsymmetric()) return add_pair(element, p, q, 0.5 * (pq + qp.transpose()));
    const Slot slot = table_->at(element, p, q);
    add(matrix_->lower(slot.block).data(), (slot.transposed ? qp : pq).data());
    add(matrix_->upper(slot.block).data(), (slot.transposed ? pq : qp).data());
  }

 private:
  void add_pair_to(Slot slot, const Matrix3& block_below);
  [[gnu::always_inline]] static void add(double* __restrict target, const double* __restrict block) {
    for (int i = 0; i < 8; ++i) target[i] += block[i];  // one vector, or a few
    target[8] += block[8];
  }

  BlockMatrix* matrix_;
  const SlotTable* table_;
};

}  // namespace sundrape

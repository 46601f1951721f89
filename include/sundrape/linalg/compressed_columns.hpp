#pragma once
#include <cstdint>
#include <vector>

#include "sundrape/linalg/block_matrix.hpp"

namespace sundrape {

/// A block matrix written out entry by entry, compressed by columns with rows ascending: what direct solvers read.
/// The pattern depends on the structure alone; values are copied in again for every matrix.
class CompressedColumns {
 public:
  enum class Part { upper_triangle, whole };

  CompressedColumns(const BlockStructure& structure, Part part);

  /// Copies the values of a matrix on the same structure. The upper triangle is that of a symmetric matrix, and of the
  /// symmetric part of an unsymmetric one.
  /// @throws std::invalid_argument  another structure
  void copy(const BlockMatrix& matrix);

  [[nodiscard]] std::int64_t columns() const { return static_cast<std::int64_t>(column_start_.size()) - 1; }
  [[nodiscard]] std::int64_t entries() const { return column_start_.back(); }
  [[nodiscard]] std::vector<std::int64_t>& column_start() { return column_start_; }  // columns() + 1
  [[nodiscard]] std::vector<std::int64_t>& row() { return row_; }                    // entries()
  [[nodiscard]] std::vector<double>& value() { return value_; }                      // entries()

 private:
  void copy_upper_triangle(const BlockMatrix& matrix);
  void copy_whole(const BlockMatrix& matrix);

  Part part_;
  BlockColumns below_;  // empty for the upper triangle
  std::vector<std::int64_t> column_start_, row_;
  std::vector<double> value_;
};

}  // namespace sundrape

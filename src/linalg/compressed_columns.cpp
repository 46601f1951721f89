#include "sundrape/linalg/compressed_columns.hpp"

#include <stdexcept>

namespace sundrape {

CompressedColumns::CompressedColumns(const BlockStructure& structure, Part part)
    : part_(part), below_(part == Part::whole ? BlockColumns(structure) : BlockColumns()) {
  column_start_.push_back(0);
  const auto add_rows = [&](std::int64_t block_row, int count) {
    for (int r = 0; r < count; ++r) row_.push_back(3 * block_row + r);
  };
  // Block row i of the stored lower triangle is, transposed, block column i of the upper one.
  for (int i = 0; i < structure.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const auto block_column = static_cast<std::size_t>(i);
      for (auto k = structure.row_start[block_column]; k < structure.diagonal(i); ++k)
        add_rows(structure.column[static_cast<std::size_t>(k)], 3);
      add_rows(i, part == Part::whole ? 3 : c + 1);
      if (part == Part::whole)
        for (auto k = below_.start[block_column]; k < below_.start[block_column + 1]; ++k)
          add_rows(below_.row[static_cast<std::size_t>(k)], 3);
      column_start_.push_back(std::ssize(row_));
    }
  value_.resize(row_.size());
}

void CompressedColumns::copy(const BlockMatrix& matrix) {
  const auto& structure = matrix.structure();
  const auto below = structure.blocks() - structure.size();
  const auto expected = part_ == Part::whole ? 9 * (2 * below + structure.size()) : 9 * below + 6 * structure.size();
  if (3 * std::int64_t{structure.size()} != columns() || expected != entries())
    throw std::invalid_argument("the matrix has another structure than the one analysed");
  if (part_ == Part::whole)
    copy_whole(matrix);
  else
    copy_upper_triangle(matrix);
}

void CompressedColumns::copy_upper_triangle(const BlockMatrix& matrix) {
  const auto& structure = matrix.structure();
  const bool twins = matrix.symmetry() == Symmetry::unsymmetric;
  auto value = value_.begin();
  for (int i = 0; i < structure.size(); ++i) {
    const Matrix3 diagonal = matrix.diagonal(i);
    for (int c = 0; c < 3; ++c) {
      for (auto k = structure.row_start[static_cast<std::size_t>(i)]; k < structure.diagonal(i); ++k) {
        const auto lower = matrix.lower(k);
        for (int r = 0; r < 3; ++r) *value++ = twins ? 0.5 * (lower(c, r) + matrix.upper(k)(r, c)) : lower(c, r);
      }
      for (int r = 0; r <= c; ++r) *value++ = 0.5 * (diagonal(r, c) + diagonal(c, r));
    }
  }
}

void CompressedColumns::copy_whole(const BlockMatrix& matrix) {
  const auto& structure = matrix.structure();
  const bool twins = matrix.symmetry() == Symmetry::unsymmetric;
  auto value = value_.begin();
  for (int i = 0; i < structure.size(); ++i) {
    const auto block_column = static_cast<std::size_t>(i);
    const Matrix3 diagonal = matrix.diagonal(i);
    for (int c = 0; c < 3; ++c) {
      for (auto k = structure.row_start[block_column]; k < structure.diagonal(i); ++k)
        for (int r = 0; r < 3; ++r) *value++ = twins ? matrix.upper(k)(r, c) : matrix.lower(k)(c, r);
      for (int r = 0; r < 3; ++r) *value++ = diagonal(r, c);
      for (auto k = below_.start[block_column]; k < below_.start[block_column + 1]; ++k)
        for (int r = 0; r < 3; ++r) *value++ = matrix.lower(below_.block[static_cast<std::size_t>(k)])(r, c);
    }
  }
}

}  // namespace sundrape

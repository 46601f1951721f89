#include "sundrape/linalg/padded_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "lanes.hpp"
#include "side_by_side.hpp"

namespace sundrape {
namespace {

/// Reads one number beyond the block: the first of the block or scratch block that follows it.
void store_scaled(float* __restrict out, const double* __restrict block, double factor) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 4; ++row) out[4 * column + row] = static_cast<float>(factor * block[3 * column + row]);
    out[4 * column + 3] = 0;
  }
}

}  // namespace

void pad(ConstVectorRef v, double factor, PaddedRef out) {
  for (Eigen::Index i = 0; i < v.size() / 3; ++i) {
    out.segment<3>(4 * i) = (factor * v.segment<3>(3 * i)).cast<float>();
    out[4 * i + 3] = 0;
  }
}

void unpad(ConstPaddedRef v, double factor, VectorRef out) {
  for (Eigen::Index i = 0; i < v.size() / 4; ++i) out.segment<3>(3 * i) = factor * v.segment<3>(4 * i).cast<double>();
}

PaddedMatrix::PaddedMatrix(const BlockStructure& structure)
    : structure_(&structure), columns_(structure), blocks_(block_floats * structure.blocks()) {}

void PaddedMatrix::copy(const BlockMatrix& matrix) {
  if (matrix.symmetry() != Symmetry::symmetric) throw std::invalid_argument("an unsymmetric matrix has no padded copy");
  if (matrix.size() != size() || matrix.structure().blocks() != structure_->blocks())
    throw std::invalid_argument("the matrix has another structure than the one analysed");
  scale_ = 0;
  for (int i = 0; i < size(); ++i)
    scale_ = std::max(scale_, matrix.lower(structure_->diagonal(i)).diagonal().cwiseAbs().maxCoeff());
  if (!(scale_ > 0 && std::isfinite(scale_))) scale_ = 1;
  const double factor = 1 / scale_;
  for (int i = 0; i < size(); ++i) {
    const auto diagonal = structure_->diagonal(i);
    for (auto k = structure_->row_start[static_cast<std::size_t>(i)]; k < diagonal; ++k)
      store_scaled(&blocks_[block_floats * k], matrix.lower(k).data(), factor);
    Eigen::Map<Eigen::Matrix<float, 4, 3>> padded(&blocks_[block_floats * diagonal]);
    padded.topRows<3>() = (factor * matrix.diagonal(i)).cast<float>();
    padded.row(3).setZero();
  }
}

// Each block is read twice, by its row and by its column, which is cheaper than scattering its transposed products.
template <int vectors>
void PaddedMatrix::multiply_each(const float* x, float* y) const {
  constexpr Eigen::Index length = 4 * vectors;
  const auto* block = blocks_.data();
  for (int i = 0; i < size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    std::array<Sum, vectors> sum;
    for (auto k = structure_->row_start[row]; k < structure_->row_start[row + 1]; ++k) {
      const auto b = load_block(block + block_floats * k);
      const float* const from = x + length * structure_->column[static_cast<std::size_t>(k)];
      for (std::size_t v = 0; v < vectors; ++v) sum[v].add(b, from + 4 * v);
    }
    std::array<TransposedSum, vectors> below;
    for (auto k = columns_.start[row]; k < columns_.start[row + 1]; ++k) {
      const auto place = static_cast<std::size_t>(k);
      const auto b = load_block(block + block_floats * columns_.block[place]);
      const float* const from = x + length * columns_.row[place];
      for (std::size_t v = 0; v < vectors; ++v) below[v].add(b, load(from + 4 * v));
    }
    for (std::size_t v = 0; v < vectors; ++v) store(y + length * i + 4 * v, sum[v].total() + below[v].total());
  }
}

void PaddedMatrix::multiply(ConstPaddedRef x, PaddedRef y) const { multiply_each<1>(x.data(), y.data()); }

void PaddedMatrix::multiply_together(ConstPaddedRef x, PaddedRef y) const {
  side_by_side(x.size() / (4 * size()), [&](auto m) { multiply_each<m>(x.data(), y.data()); });
}

}  // namespace sundrape

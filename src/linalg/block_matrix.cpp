#include "sundrape/linalg/block_matrix.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <type_traits>

#include "side_by_side.hpp"

namespace sundrape {
namespace {

/// y = A x of m columns that lie one after the other, A unsymmetric: row i is the first to touch y_i.
template <std::size_t m>
void multiply_columns(const BlockMatrix& a, const double* x, double* y) {
  const auto& structure = a.structure();
  const Eigen::Index n = 3 * Eigen::Index{a.size()};
  const auto at = [n](auto* v, std::size_t column, Eigen::Index row) {
    return Eigen::Map<std::conditional_t<std::is_const_v<std::remove_pointer_t<decltype(v)>>, const Vector3, Vector3>>(
        v + n * static_cast<Eigen::Index>(column) + 3 * row);
  };
  for (int i = 0; i < a.size(); ++i) {
    std::array<Vector3, m> x_i, sum;
    const auto own = a.lower(structure.diagonal(i));
    for (std::size_t c = 0; c < m; ++c) {
      x_i[c] = at(x, c, i);
      sum[c] = own * x_i[c];
    }
    for (auto k = structure.row_start[static_cast<std::size_t>(i)]; k < structure.diagonal(i); ++k) {
      const auto j = structure.column[static_cast<std::size_t>(k)];
      const auto below = a.lower(k), above = a.upper(k);
      for (std::size_t c = 0; c < m; ++c) {
        sum[c] += below * at(x, c, j);
        at(y, c, j) += above * x_i[c];
      }
    }
    for (std::size_t c = 0; c < m; ++c) at(y, c, i) = sum[c];
  }
}

/// One 3-vector of x; x may be const or not.
template <class V>
auto row3(V& x, std::int64_t i) {
  return x.template segment<3>(3 * i);
}

}  // namespace

BlockMatrix::BlockMatrix(const BlockStructure& structure, Symmetry symmetry)
    : structure_(&structure),
      symmetry_(symmetry),
      lower_(9 * (static_cast<std::size_t>(structure.blocks()) + 1), 0.0),
      upper_(symmetry == Symmetry::unsymmetric ? lower_.size() : 0, 0.0) {}

void BlockMatrix::set_zero() {
  std::ranges::fill(lower_, 0.0);
  std::ranges::fill(upper_, 0.0);
}

void BlockMatrix::add_diagonal(ConstVectorRef mass, double mass_factor) {
  if (mass.size() != size()) throw std::invalid_argument("a diagonal has one entry a block row");
  for (int i = 0; i < size(); ++i) lower(structure_->diagonal(i)).diagonal().array() += mass_factor * mass[i];
}

void BlockMatrix::hold(int row, int component, double value) {
  if (!columns_) columns_.emplace(*structure_);
  const auto i = static_cast<std::size_t>(row);
  const bool both = symmetry_ == Symmetry::unsymmetric;
  for (auto k = structure_->row_start[i]; k <= structure_->diagonal(row); ++k) {
    lower(k).row(component).setZero();
    if (both) upper(k).col(component).setZero();
  }
  for (auto k = columns_->start[i]; k < columns_->start[i + 1]; ++k) {
    const auto below = columns_->block[static_cast<std::size_t>(k)];
    lower(below).col(component).setZero();
    if (both) upper(below).row(component).setZero();
  }
  auto diagonal = lower(structure_->diagonal(row));
  diagonal.col(component).setZero();
  diagonal(component, component) = value;
}

Matrix3 BlockMatrix::diagonal(int row) const {
  const auto block = lower(structure_->diagonal(row));
  if (symmetry_ == Symmetry::unsymmetric) return block;
  return 0.5 * (block + block.transpose());
}

void BlockMatrix::multiply(ConstVectorRef x, VectorRef y) const {
  if (x.size() != 3 * size() || y.size() != 3 * size())
    throw std::invalid_argument("a vector does not have the length of its matrix");
  if (symmetry_ == Symmetry::symmetric)
    multiply_symmetric(x, y);
  else
    multiply_columns<1>(*this, x.data(), y.data());
}

// Row i is the first to touch y_i (rows below add to it later), so y needs no clearing.
void BlockMatrix::multiply_symmetric(ConstVectorRef x, VectorRef y) const {
  for (int i = 0; i < size(); ++i) {
    const Vector3 x_i = row3(x, i);
    const auto own = lower(structure_->diagonal(i));
    Vector3 sum = 0.5 * (own * x_i + own.transpose() * x_i);
    for (auto k = structure_->row_start[static_cast<std::size_t>(i)]; k < structure_->diagonal(i); ++k) {
      const auto j = structure_->column[static_cast<std::size_t>(k)];
      const auto block = lower(k);
      sum += block * row3(x, j);
      row3(y, j) += block.transpose() * x_i;
    }
    row3(y, i) = sum;
  }
}

void BlockMatrix::multiply_all(const Eigen::MatrixXd& x, Eigen::MatrixXd& y) const {
  if (x.rows() != 3 * size()) throw std::invalid_argument("a vector does not have the length of its matrix");
  y.resize(x.rows(), x.cols());
  if (symmetry_ == Symmetry::symmetric) {
    for (Eigen::Index c = 0; c < x.cols(); ++c) multiply_symmetric(x.col(c), y.col(c));
    return;
  }
  constexpr Eigen::Index most = PaddedMatrix::together;
  for (Eigen::Index c = 0; c < x.cols(); c += most) {
    side_by_side(std::min<Eigen::Index>(most, x.cols() - c),
                 [&](auto m) { multiply_columns<m>(*this, x.data() + c * x.rows(), y.data() + c * y.rows()); });
  }
}

// Stored is (larger row, smaller row): the block itself if its row is the larger, its transpose otherwise.
void Assembler::add_pair_to(Slot slot, const Matrix3& block_below) {
  if (slot.transposed)
    matrix_->lower(slot.block) += block_below;
  else
    matrix_->lower(slot.block) += block_below.transpose();
  if (!keeps_unsymmetric()) return;
  if (slot.transposed)
    matrix_->upper(slot.block) += block_below.transpose();
  else
    matrix_->upper(slot.block) += block_below;
}

double BlockMatrix::asymmetry() const {
  if (symmetry_ == Symmetry::symmetric) return 0;
  double largest = 0;
  double difference = 0;
  for (int i = 0; i < size(); ++i) {
    const auto last = structure_->diagonal(i);
    for (auto k = structure_->row_start[static_cast<std::size_t>(i)]; k <= last; ++k) {
      const Matrix3 twin = k == last ? lower(k) : upper(k);
      largest = std::max({largest, lower(k).cwiseAbs().maxCoeff(), twin.cwiseAbs().maxCoeff()});
      difference = std::max(difference, (lower(k) - twin.transpose()).cwiseAbs().maxCoeff());
    }
  }
  return largest > 0 ? difference / largest : 0;
}

Eigen::MatrixXd BlockMatrix::dense() const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * size(), 3 * size());
  for (int i = 0; i < size(); ++i) {
    for (auto k = structure_->row_start[static_cast<std::size_t>(i)]; k < structure_->diagonal(i); ++k) {
      const auto j = structure_->column[static_cast<std::size_t>(k)];
      all.block<3, 3>(3 * i, 3 * j) = lower(k);
      if (symmetry_ == Symmetry::symmetric)
        all.block<3, 3>(3 * j, 3 * i) = lower(k).transpose();
      else
        all.block<3, 3>(3 * j, 3 * i) = upper(k);
    }
    all.block<3, 3>(3 * i, 3 * i) = diagonal(i);
  }
  return all;
}

}  // namespace sundrape

#include "sundrape/linalg/block_incomplete_cholesky.hpp"

#include <algorithm>
#include <stdexcept>

#include "lanes.hpp"
#include "side_by_side.hpp"

namespace sundrape {
namespace {

constexpr auto block_floats = PaddedMatrix::block_floats;
constexpr double first_shift = 1e-3;
constexpr double largest_shift = 10;
// A pivot that cancels below this part of its diagonal block is noise in single precision, or about to blow up.
constexpr float least_pivot = 1e-5F;

using PaddedBlock = Eigen::Map<Eigen::Matrix<float, 4, 3>>;

/// Inverse of a symmetric 3×3 block whose pivots all exceed `least`; false if one does not.
bool invert_definite(const Matrix3& a, double least, Matrix3& inverse) {
  // pivots are ratios of leading minors; the adjugate needs one division where elimination needs three in a row
  Matrix3 adjugate;
  adjugate(0, 0) = a(1, 1) * a(2, 2) - a(2, 1) * a(2, 1);
  adjugate(1, 0) = a(2, 0) * a(2, 1) - a(1, 0) * a(2, 2);
  adjugate(2, 0) = a(1, 0) * a(2, 1) - a(2, 0) * a(1, 1);
  adjugate(1, 1) = a(0, 0) * a(2, 2) - a(2, 0) * a(2, 0);
  adjugate(2, 1) = a(1, 0) * a(2, 0) - a(0, 0) * a(2, 1);
  adjugate(2, 2) = a(0, 0) * a(1, 1) - a(1, 0) * a(1, 0);
  const double minor = adjugate(2, 2);
  const double determinant = a(0, 0) * adjugate(0, 0) + a(1, 0) * adjugate(1, 0) + a(2, 0) * adjugate(2, 0);
  if (!(a(0, 0) > least && minor > least * a(0, 0) && determinant > least * minor)) return false;
  inverse = (1 / determinant) * adjugate.selfadjointView<Eigen::Lower>().toDenseMatrix();
  return true;
}

void subtract(float* target, const LaneBlock& b) {
  const auto t = load_block(target);
  store_block(target, {t.c0 - b.c0, t.c1 - b.c1, t.c2 - b.c2});
}

}  // namespace

BlockIncompleteCholesky::BlockIncompleteCholesky(double modification) : modification_(modification) {
  if (!(modification >= 0 && modification <= 1)) throw std::invalid_argument("the modification must lie in [0, 1]");
}

void BlockIncompleteCholesky::analyse(const BlockStructure& structure) {
  structure_ = &structure;
  columns_ = BlockColumns(structure);
  shift_ = 0;
  target_start_.assign(1, 0);
  target_.clear();
  std::int64_t longest = 0;
  for (std::size_t column = 0; column + 1 < columns_.start.size(); ++column) {
    const auto first = static_cast<std::size_t>(columns_.start[column]);
    const auto last = static_cast<std::size_t>(columns_.start[column + 1]);
    for (auto i = first; i < last; ++i)
      for (auto j = first; j < i; ++j) target_.push_back(structure.find(columns_.row[i], columns_.row[j]));
    target_start_.push_back(std::ssize(target_));
    longest = std::max(longest, columns_.start[column + 1] - columns_.start[column]);
  }
  blocks_.resize(block_floats * structure.blocks());
  unscaled_.resize(block_floats * longest);
  floor_.resize(static_cast<std::size_t>(structure.size()));
}

bool BlockIncompleteCholesky::build(const PaddedMatrix& matrix) {
  shift_ = shift_ < first_shift ? 0 : 0.5 * shift_;
  while (!factorise(matrix)) {
    shift_ = std::max(first_shift, 2 * shift_);
    if (shift_ > largest_shift) return false;
  }
  return true;
}

bool BlockIncompleteCholesky::factorise(const PaddedMatrix& matrix) {
  blocks_ = matrix.blocks();
  for (int i = 0; i < structure_->size(); ++i) {
    PaddedBlock diagonal(&blocks_[block_floats * structure_->diagonal(i)]);
    const float largest = diagonal.cwiseAbs().maxCoeff();
    floor_[static_cast<std::size_t>(i)] = least_pivot * largest;
    diagonal.diagonal().array() += static_cast<float>(shift_) * largest;
  }
  for (int k = 0; k < structure_->size(); ++k) {
    if (!invert_diagonal(k)) return false;
    eliminate(k);
  }
  return true;
}

bool BlockIncompleteCholesky::invert_diagonal(int row) {
  PaddedBlock diagonal(&blocks_[block_floats * structure_->diagonal(row)]);
  const Matrix3 block = diagonal.topRows<3>().cast<double>();
  Matrix3 inverse;
  // dropped fill came in without its transpose, hence the mean
  const Matrix3 mean = 0.5 * (block + block.transpose());
  if (!invert_definite(mean, floor_[static_cast<std::size_t>(row)], inverse)) return false;
  diagonal.topRows<3>() = inverse.cast<float>();
  return true;
}

/// Column k: L_ik = A_ik D_k⁻¹, and A_ij −= L_ik A_jkᵀ for all its pairs i ≥ j.
void BlockIncompleteCholesky::eliminate(int column) {
  const auto first = static_cast<std::size_t>(columns_.start[static_cast<std::size_t>(column)]);
  const auto last = static_cast<std::size_t>(columns_.start[static_cast<std::size_t>(column) + 1]);
  float* const block = blocks_.data();
  const float* const inverse = block + block_floats * structure_->diagonal(column);  // symmetric
  const auto* target = target_.data() + target_start_[static_cast<std::size_t>(column)];
  const auto diagonal = [&](std::size_t place) {
    return block + block_floats * structure_->diagonal(columns_.row[place]);
  };
  const auto kept = static_cast<float>(modification_);
  for (auto i = first; i < last; ++i) {
    float* const unscaled_i = unscaled_.data() + block_floats * static_cast<std::int64_t>(i - first);
    float* const entry = block + block_floats * columns_.block[i];
    store_block(unscaled_i, load_block(entry));
    const auto scaled = times_transposed(load_block(unscaled_i), inverse);
    store_block(entry, scaled);
    for (auto j = first; j < i; ++j) {
      const auto update =
          times_transposed(scaled, unscaled_.data() + block_floats * static_cast<std::int64_t>(j - first));
      if (*target >= 0) {
        subtract(block + block_floats * *target, update);
      } else if (kept > 0) {
        const LaneBlock moved{Lanes(kept) * update.c0, Lanes(kept) * update.c1, Lanes(kept) * update.c2};
        subtract(diagonal(i), moved);
        subtract(diagonal(j), moved);
      }
      ++target;
    }
    subtract(diagonal(i), times_transposed(scaled, unscaled_i));
  }
}

template <int vectors>
void BlockIncompleteCholesky::apply_to(const float* r, float* z) const {
  constexpr Eigen::Index row = 4 * vectors;
  const float* const block = blocks_.data();
  const int n = structure_->size();
  for (int i = 0; i < n; ++i) {  // (I + L) w = r
    std::array<Sum, vectors> sum;
    for (auto k = structure_->row_start[static_cast<std::size_t>(i)]; k < structure_->diagonal(i); ++k) {
      const auto b = load_block(block + block_floats * k);
      const float* const from = z + row * structure_->column[static_cast<std::size_t>(k)];
      for (std::size_t v = 0; v < vectors; ++v) sum[v].add(b, from + 4 * v);
    }
    for (std::size_t v = 0; v < vectors; ++v) store(z + row * i + 4 * v, load(r + row * i + 4 * v) - sum[v].total());
  }
  for (int j = n - 1; j >= 0; --j) {  // (I + Lᵀ) z = D⁻¹ w
    float* const z_j = z + row * j;
    const auto inverse = load_block(block + block_floats * structure_->diagonal(j));
    std::array<Sum, vectors> scaled;
    std::array<TransposedSum, vectors> below;
    for (std::size_t v = 0; v < vectors; ++v) scaled[v].add(inverse, z_j + 4 * v);
    for (auto k = columns_.start[static_cast<std::size_t>(j) + 1]; k-- > columns_.start[static_cast<std::size_t>(j)];) {
      const auto place = static_cast<std::size_t>(k);
      const auto b = load_block(block + block_floats * columns_.block[place]);
      const float* const from = z + row * columns_.row[place];
      for (std::size_t v = 0; v < vectors; ++v) below[v].add(b, load(from + 4 * v));
    }
    for (std::size_t v = 0; v < vectors; ++v) store(z_j + 4 * v, scaled[v].total() - below[v].total());
  }
}

void BlockIncompleteCholesky::apply(ConstPaddedRef r, PaddedRef z) const { apply_to<1>(r.data(), z.data()); }

void BlockIncompleteCholesky::apply_together(ConstPaddedRef r, PaddedRef z) const {
  side_by_side(r.size() / (4 * structure_->size()), [&](auto m) { apply_to<m>(r.data(), z.data()); });
}

}  // namespace sundrape

#pragma once

#include <Eigen/Core>

namespace sundrape {

/// Three numbers of a block row and a padding zero in one SIMD register.
using Lanes = Eigen::Array4f;

inline Lanes load(const float* p) { return Eigen::Map<const Lanes, Eigen::Aligned16>(p); }
inline void store(float* p, const Lanes& lanes) { Eigen::Map<Lanes, Eigen::Aligned16>{p} = lanes; }

/// A 3×3 block, one register a column.
struct LaneBlock {
  Lanes c0, c1, c2;
};

inline LaneBlock load_block(const float* p) { return {load(p), load(p + 4), load(p + 8)}; }
inline void store_block(float* p, const LaneBlock& b) {
  store(p, b.c0);
  store(p + 4, b.c1);
  store(p + 8, b.c2);
}

/// sum + B x, x being read from memory.
inline Lanes plus_product(const Lanes& sum, const LaneBlock& b, const float* x) {
  return sum + b.c0 * Lanes::Constant(x[0]) + b.c1 * Lanes::Constant(x[1]) + b.c2 * Lanes::Constant(x[2]);
}

/// Gathers Σ Bᵀ x over many blocks; only the end costs sums across lanes.
struct TransposedSum {
  LaneBlock products{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};

  void add(const LaneBlock& b, const Lanes& x) {
    products.c0 += b.c0 * x;
    products.c1 += b.c1 * x;
    products.c2 += b.c2 * x;
  }
  [[nodiscard]] Lanes total() const { return {products.c0.sum(), products.c1.sum(), products.c2.sum(), 0.0F}; }
};

/// B Cᵀ.
inline LaneBlock times_transposed(const LaneBlock& b, const float* c) {
  const auto column = [&](int i) -> Lanes {
    return b.c0 * Lanes::Constant(c[i]) + b.c1 * Lanes::Constant(c[4 + i]) + b.c2 * Lanes::Constant(c[8 + i]);
  };
  return {column(0), column(1), column(2)};
}

}  // namespace sundrape

#pragma once

#include <array>

#include <xsimd/xsimd.hpp>

namespace sundrape {

/// Three numbers of a block row and a padding zero in one SIMD register.
using Lanes = xsimd::make_sized_batch_t<float, 4>;

inline Lanes load(const float* p) { return Lanes::load_aligned(p); }
inline void store(float* p, const Lanes& lanes) { lanes.store_aligned(p); }

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

/// Gathers Σ B x over many blocks, in three chains so that none waits for another.
struct Sum {
  LaneBlock products{Lanes(0.0F), Lanes(0.0F), Lanes(0.0F)};

  /// x is read from memory.
  void add(const LaneBlock& b, const float* x) {
    products.c0 = xsimd::fma(b.c0, Lanes(x[0]), products.c0);
    products.c1 = xsimd::fma(b.c1, Lanes(x[1]), products.c1);
    products.c2 = xsimd::fma(b.c2, Lanes(x[2]), products.c2);
  }
  [[nodiscard]] Lanes total() const { return (products.c0 + products.c1) + products.c2; }
};

/// Gathers Σ Bᵀ x over many blocks; only the end costs sums across lanes.
struct TransposedSum {
  LaneBlock products{Lanes(0.0F), Lanes(0.0F), Lanes(0.0F)};

  void add(const LaneBlock& b, const Lanes& x) {
    products.c0 = xsimd::fma(b.c0, x, products.c0);
    products.c1 = xsimd::fma(b.c1, x, products.c1);
    products.c2 = xsimd::fma(b.c2, x, products.c2);
  }
  [[nodiscard]] Lanes total() const {
    const std::array columns{products.c0, products.c1, products.c2, Lanes(0.0F)};
    return xsimd::haddp(columns.data());
  }
};

/// B Cᵀ.
inline LaneBlock times_transposed(const LaneBlock& b, const float* c) {
  const auto column = [&](int i) {
    return xsimd::fma(b.c0, Lanes(c[i]), xsimd::fma(b.c1, Lanes(c[4 + i]), b.c2 * Lanes(c[8 + i])));
  };
  return {column(0), column(1), column(2)};
}

}  // namespace sundrape

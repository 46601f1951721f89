#pragma once
// Kernels on several elements at once: one element a lane of a SIMD register. Eigen's small matrices hold batches as
// they hold doubles, so that a formula is written once for both.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>
#include <xsimd/xsimd.hpp>

#include "sundrape/force/element_table.hpp"
#include "sundrape/force/stripes.hpp"
#include "sundrape/types.hpp"

namespace sundrape {

using Batch = xsimd::batch<double>;
using Batch3 = Eigen::Matrix<Batch, 3, 1>;
using Batch3x3 = Eigen::Matrix<Batch, 3, 3>;

inline constexpr std::size_t lanes = Batch::size;

}  // namespace sundrape

template <>
struct Eigen::NumTraits<sundrape::Batch> : Eigen::NumTraits<double> {
  using Real = sundrape::Batch;
  using NonInteger = sundrape::Batch;
  using Nested = sundrape::Batch;
  using Literal = sundrape::Batch;
  enum { RequireInitialization = 0 };  // NOLINT(readability-identifier-naming): Eigen's name
};

namespace sundrape {

/// Number k of `lanes` elements of a table from e on.
template <std::size_t points, std::size_t numbers>
Batch load(const ElementTable<points, numbers>& table, std::size_t k, std::size_t e) {
  static_assert(lanes <= 8, "an ElementTable pads its columns for registers of 8 doubles");
  return Batch::load_unaligned(table.column(k, e));
}

/// The 3-vectors that x has for point p of `lanes` elements from e on.
template <std::size_t points, std::size_t numbers>
Batch3 gather(const ConstVectorRef& x, const ElementTable<points, numbers>& table, std::size_t p, std::size_t e) {
  const double* const from = x.data();
  const std::int64_t* const start = table.starts(p, e);
  std::array<Batch, 3> components;
  for (std::size_t i = 0; i < 3; ++i) {
    alignas(64) std::array<double, lanes> of_lane;  // a plain loop: the compiler knows the machine's gather
    for (std::size_t lane = 0; lane < lanes; ++lane) of_lane[lane] = from[start[lane] + static_cast<std::int64_t>(i)];
    components[i] = Batch::load_aligned(of_lane.data());
  }
  return {components[0], components[1], components[2]};
}

/// Numbers of a batch, lane by lane, in memory.
template <std::size_t size>
class LaneBuffer {
 public:
  void store(std::size_t k, const Batch& numbers) { numbers.store_aligned(values_.data() + k * lanes); }
  /// A vector, from number k on.
  template <class Derived>
  void store(std::size_t k, const Eigen::MatrixBase<Derived>& vector) {
    const Batch3 evaluated = vector;
    for (Eigen::Index i = 0; i < 3; ++i) store(k + static_cast<std::size_t>(i), evaluated[i]);
  }
  [[nodiscard]] double operator()(std::size_t k, std::size_t lane) const { return values_[k * lanes + lane]; }

 private:
  alignas(64) std::array<double, size * lanes> values_;
};

/// Transposes the first numbers of every lane to first[9 lane]; returns how many: all 8 that fit a register of 8 lanes,
/// none on machines with narrower ones.
#ifdef __AVX512F__
inline std::size_t store_transposed(const Batch* numbers, double* first) {
  __m512d a[8], b[8];  // NOLINT(modernize-avoid-c-arrays): the attributes of the type do not survive std::array
  for (std::size_t i = 0; i < 8; i += 2) {  // pairs, then fours, then eights
    const __m512d even = numbers[i], odd = numbers[i + 1];
    a[i] = __builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14);
    a[i + 1] = __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (const std::size_t i : {0UL, 1UL, 4UL, 5UL}) {
    b[i] = __builtin_shufflevector(a[i], a[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    b[i + 2] = __builtin_shufflevector(a[i], a[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    _mm512_storeu_pd(first + 9 * i, __builtin_shufflevector(b[i], b[i + 4], 0, 1, 2, 3, 8, 9, 10, 11));
    _mm512_storeu_pd(first + 9 * (i + 4), __builtin_shufflevector(b[i], b[i + 4], 4, 5, 6, 7, 12, 13, 14, 15));
  }
  return 8;
}
#else
inline std::size_t store_transposed(const Batch* /*numbers*/, double* /*first*/) { return 0; }
#endif

/// 3×3 matrices of a batch, each lane's in one piece.
template <std::size_t count>
class LaneMatrices {
 public:
  template <class Derived>
  void store(std::size_t k, const Eigen::MatrixBase<Derived>& matrix) {
    const Batch3x3 evaluated = matrix;
    double* const first = matrices_[k][0].data();
    const auto done = store_transposed(evaluated.data(), first);
    alignas(64) std::array<double, lanes> numbers;
    for (std::size_t i = done; i < 9; ++i) {
      evaluated.data()[i].store_aligned(numbers.data());
      for (std::size_t lane = 0; lane < lanes; ++lane) first[9 * lane + i] = numbers[lane];
    }
  }
  [[nodiscard]] const Matrix3& operator()(std::size_t k, std::size_t lane) const { return matrices_[k][lane]; }

 private:
  std::array<std::array<Matrix3, lanes>, count> matrices_;
};

/// Calls body(e, count) for batches of elements e, e + 1, …, of which the first `count` ≤ `lanes` count.
template <class Body>
void for_each_batch(const Stripes& stripes, const Body& body) {
  stripes.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; e += lanes) body(e, std::min(lanes, end - e));
  });
}

/// Σ over all elements of what kernel(e) gives for `lanes` of them from e on.
template <class Kernel>
double sum_over_batches(const Stripes& stripes, const Kernel& kernel) {
  return stripes.sum([&](std::size_t begin, std::size_t end) {
    double sum = 0;
    LaneBuffer<1> values;
    for (auto e = begin; e < end; e += lanes) {
      values.store(0, kernel(e));
      for (std::size_t lane = 0; lane < std::min(lanes, end - e); ++lane) sum += values(0, lane);
    }
    return sum;
  });
}

/// Adds what kernel(e) gives for `lanes` elements from e on [J], an even share to each of their points `first` …
/// `last`.
template <std::size_t points, std::size_t numbers, class Kernel>
void share_among_points(const Stripes& stripes, const ElementTable<points, numbers>& table, std::size_t first,
                        std::size_t last, const Kernel& kernel, VectorRef of_points) {
  for_each_batch(stripes, [&](std::size_t e, std::size_t count) {
    LaneBuffer<1> energies;
    energies.store(0, kernel(e));
    for (std::size_t lane = 0; lane < count; ++lane)
      for (auto p = first; p <= last; ++p)
        of_points[table.point_of(p, e + lane)] += energies(0, lane) / static_cast<double>(last - first + 1);
  });
}

/// Adds to f, for each point p of `count` elements from e on, the buffer's vector p (numbers 3p … 3p + 2).
template <std::size_t points, std::size_t numbers>
void scatter_add(const LaneBuffer<3 * points>& buffer, const ElementTable<points, numbers>& table, std::size_t e,
                 std::size_t count, VectorRef f) {
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t lane = 0; lane < count; ++lane) {
      double* const target = f.data() + table.starts(p, e)[lane];
      for (std::size_t i = 0; i < 3; ++i) target[i] += buffer(3 * p + i, lane);
    }
}

}  // namespace sundrape

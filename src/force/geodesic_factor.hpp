#pragma once
#include "batch.hpp"

namespace sundrape {

/// F(w) = asin(√w)/√w and its first two derivatives: what turns the chord between two unit directors, of length 2√w,
/// into the angle between them. Past w = 0.9 (143° from one edge of an element to the other) it goes on as the parabola
/// that it has there, so that it stays finite and twice continuously differentiable.
struct GeodesicFactor {
  Batch value, first, second;

  explicit GeodesicFactor(const Batch& w) {
    constexpr double small = 0.01, large = 0.9;
    const Batch inside = xsimd::min(w, Batch(large)), z = xsimd::max(inside, Batch(small));
    const Batch root = xsimd::sqrt(z), cosine2 = Batch(1.0) - z, secant = Batch(1.0) / xsimd::sqrt(cosine2);
    value = xsimd::asin(root) / root;
    first = (secant - value) / (Batch(2.0) * z);
    second = (Batch(0.5) * secant / cosine2 - Batch(3.0) * first) / (Batch(2.0) * z);

    // Σ (2k)!/(4^k k!² (2k + 1)) w^k where the closed forms cancel
    constexpr std::array<double, 8> series{1.0,         1.0 / 6,     3.0 / 40,      5.0 / 112,
                                           35.0 / 1152, 63.0 / 2816, 231.0 / 13312, 143.0 / 10240};
    Batch s0(0.0), s1(0.0), s2(0.0);
    for (std::size_t k = series.size(); k-- > 0;) {
      s2 = s2 * inside + Batch(2.0) * s1;
      s1 = s1 * inside + s0;
      s0 = s0 * inside + Batch(series[k]);
    }
    const auto near_zero = inside < Batch(small);
    value = xsimd::select(near_zero, s0, value);
    first = xsimd::select(near_zero, s1, first);
    second = xsimd::select(near_zero, s2, second);

    const Batch beyond = w - inside;
    value += beyond * (first + Batch(0.5) * beyond * second);
    first += beyond * second;
  }
};

}  // namespace sundrape

#pragma once
#include "batch.hpp"

namespace sundrape {

/// N(w) = 1 + s (1/√(1 − w) − 1) and its first two derivatives; past w = 0.9 it goes on as the parabola that it has
/// there. With w the square of half the chord between the directors of two opposite sides, 1/√(1 − w) gives the part
/// of a director that is left between them its length back. s is 0 or 1.
struct LateralFactor {
  Batch value, first, second;

  LateralFactor(const Batch& w, const Batch& s) {
    const Batch inside = xsimd::min(w, Batch(0.9)), rest = Batch(1.0) / (Batch(1.0) - inside), root = xsimd::sqrt(rest);
    value = Batch(1.0) + s * (root - Batch(1.0));
    first = s * Batch(0.5) * root * rest;
    second = Batch(1.5) * first * rest;
    const Batch beyond = w - inside;
    value += beyond * (first + Batch(0.5) * beyond * second);
    first += beyond * second;
  }
};

}  // namespace sundrape

#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sundrape {

/// What keeps a hinge from closing: a barrier that two edges of a thread meet when they nearly lie on each other.
///
/// Between φ₀ = 150° and a half turn a spring of stiffness k stores, besides the energy of its bending,
///     k κ w² x³/(1 − x),   x = (|φ| − φ₀)/w,   w = π − φ₀,
/// three times differentiable but for the third at φ₀, and without bound at π: a thread that folds so sharply lies on
/// itself, where contact does not look because the two are neighbours, and beyond π it would have gone through itself.
/// A mesh that follows the cloth never comes there. Over k that is what these three say, as in BendResponse; φ is the
/// angle itself, not that from rest.
template <class Real>
struct FoldLimit {
  Real turn;    // ∂E/∂φ/k [rad]
  Real slope;   // ∂²E/∂φ²/k [-]
  Real energy;  // E/k [rad²]
};

/// From where on the barrier acts [rad], as a magnitude.
inline constexpr double fold_limit_begin = 150 * std::numbers::pi / 180;

/// @param angle   φ in (−π, π) [rad]
/// @tparam Real   double, or a SIMD batch of them
template <class Real>
[[nodiscard]] FoldLimit<Real> fold_limit(const Real& angle) {
  using std::abs, std::copysign, std::max;
  constexpr double width = std::numbers::pi - fold_limit_begin;
  constexpr double strength = 50;   // κ: at 0.9 of the width, 20 times what a linear spring stores at π
  constexpr double closest = 1e-6;  // finite where rounding puts a hinge at π itself
  const Real one(1), x = max((abs(angle) - Real(fold_limit_begin)) * Real(1 / width), Real(0));
  const Real open = one / max(one - x, Real(closest)), x2 = x * x;
  return {copysign(Real(strength * width) * x2 * (Real(3) - Real(2) * x) * open * open, angle),
          Real(2 * strength) * x * (Real(3) - Real(3) * x + x2) * open * open * open,
          Real(strength * width * width) * x2 * x * open};
}

}  // namespace sundrape

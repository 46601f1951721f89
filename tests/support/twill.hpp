#pragma once
#include <array>
#include <cmath>

#include "sundrape/material/moment_curvature.hpp"

namespace sundrape::twill {

/// The article's cotton twill: M = Σ α_k K^k for K up to `max_curvature`, measured as gf cm/cm against 1/cm.
inline constexpr double gf = 9.80665e-3;                                             // [N]
inline constexpr std::array printed{1.33387, -2.23070, 2.36510, -1.08471, 0.17876};  // [gf cm/cm · cm^k]
inline constexpr double max_curvature = 250;                                         // [1/m]
inline constexpr double weight = 0.02665 * gf * 1e4;                                 // per area [N/m²]
inline constexpr std::array alpha{printed[0] * gf * 1e-2, printed[1] * gf * 1e-4, printed[2] * gf * 1e-6,
                                  printed[3] * gf * 1e-8, printed[4] * gf * 1e-10};  // [N m^k]

inline MomentCurvature law() { return MomentCurvature::polynomial(alpha, max_curvature); }

/// The law written out term by term: moment per width [N], for 0 ≤ K within the fit.
inline double moment(double curvature) {
  double sum = 0;
  for (std::size_t k = 0; k < alpha.size(); ++k) sum += alpha[k] * std::pow(curvature, k + 1);
  return sum;
}
/// dM/dK [N m].
inline double slope(double curvature) {
  double sum = 0;
  for (std::size_t k = 0; k < alpha.size(); ++k) sum += static_cast<double>(k + 1) * alpha[k] * std::pow(curvature, k);
  return sum;
}
/// ∫ M dK, per area [N/m], for K of any sign and size: an even function, past the fit along the tangent.
inline double energy(double curvature) {
  const double size = std::abs(curvature), inside = std::min(size, max_curvature), beyond = size - inside;
  double sum = 0;
  for (std::size_t k = 0; k < alpha.size(); ++k) sum += alpha[k] * std::pow(inside, k + 2) / static_cast<double>(k + 2);
  return sum + moment(inside) * beyond + 0.5 * slope(inside) * beyond * beyond;
}

}  // namespace sundrape::twill

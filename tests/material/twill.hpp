#pragma once
#include <array>

#include "sundrape/material/moment_curvature.hpp"

namespace sundrape {

/// The bending test of the article's cotton twill: α_k in gf·cm/cm over the power k of a curvature in 1/cm, to 2.5 /cm.
inline constexpr std::array twill_coefficients{1.33387, -2.23070, 2.36510, -1.08471, 0.17876};
inline constexpr double twill_max_curvature = 2.5;

/// In the article's own units: moments in gf·cm/cm, curvatures in 1/cm.
inline MomentCurvature twill() { return MomentCurvature::polynomial(twill_coefficients, twill_max_curvature); }

}  // namespace sundrape

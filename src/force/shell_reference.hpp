#pragma once
#include <array>

#include "sundrape/force/shell_element.hpp"

namespace sundrape {

/// Warp–weft axes of the tangent plane at one point, and what takes covariant components there.
struct ShellAxes {
  Eigen::Matrix2d covariant;  // L_αi = A^α · e_i [1/m]: γ_i = γ_α L_αi
  Eigen::Matrix3d strain;     // (ε₁₁, ε₂₂, 2ε₁₂) from covariant ones [1/m²]
  Vector3 normal;             // A₁ × A₂, as long as the area per dξ dη [m²]
};

/// The axes at the centre of an element at rest.
[[nodiscard]] ShellAxes centre_axes(const ShellElement& element);

/// The constant numbers of one element (docs/shell.md).
///
/// With a = ¼Σξ_I x_I, b = ¼Σξ_Iη_I x_I, c = ¼Ση_I x_I the position's derivatives are x,ξ = a + ηb and x,η = c + ξb,
/// and the director's likewise. Membrane strains of every field are combinations of the six numbers
/// s = (½a·a, ½c·c, a·c, a·b, c·b, ½b·b), so their energy is ½ (s − s₀)ᵀ C (s − s₀) with one matrix C; transverse
/// shear needs the four strains tied at the middles of the edges. Curvatures are taken to warp–weft axes at each of the
/// 2×2 points of integration, (ξ, η) = (∓, ∓)1/√3 numbered with ξ running first.
struct ShellReference {
  using Strains = Eigen::Matrix<double, 6, 1>;
  using Shears = Eigen::Vector4d;

  Eigen::Matrix<double, 6, 6> membrane;  // C [N/m · m²/m⁴]: energy in J for s in m²
  Eigen::Matrix4d shear;                 // energy in J for covariant shears in m
  std::array<Eigen::Matrix3d, 4> frame;  // warp–weft (κ₁₁, κ₂₂, 2κ₁₂) from covariant ones [1/m²]
  std::array<double, 4> area;            // of each point of integration [m²]
};

inline constexpr double integration_point = 0.57735026918962576451;  // 1/√3

/// @throws std::invalid_argument  an element that is not convex: its area is negative at a point of integration
[[nodiscard]] ShellReference shell_reference(const ShellElement& element, const ShellSection& section,
                                             MembraneField field);

}  // namespace sundrape

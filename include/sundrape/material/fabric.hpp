#pragma once
#include <optional>

#include "sundrape/material/plate_bending.hpp"

namespace sundrape {

/// A fabric as resultants per unit width: what a sheet needs to know, whatever its thickness was measured to be.
struct Fabric {
  double thickness = 0;     // h [m]
  double area_density = 0;  // mass per area [kg/m²]
  double poisson = 0;  // ν, of an orthotropic fabric ν₁₂; ν₂₁ = ν₁₂ E₂/E₁, in bending ν₁₂ B₂/B₁
  double warp_membrane = 0;   // E₁ h [N/m]
  double weft_membrane = 0;   // E₂ h [N/m]
  double shear_membrane = 0;  // G h [N/m]
  double warp_bending = 0;  // D₁₁ of the sheet: B₁/(1 − ν₁₂ ν₂₁) where a strip, free to curl across, has B₁ [N m]
  double weft_bending = 0;      // D₂₂ [N m]
  double bending_coupling = 0;  // D₁₂ = ν₁₂ D₂₂ [N m]
  double twist_bending = 0;     // m₁₂ per engineering twist 2κ₁₂ [N m]
  double transverse_shear = 0;  // G_s h without a correction factor [N/m]

  /// Strips with M = f(K) instead, measured along warp and weft; the four rigidities above are then those at K = 0.
  struct MeasuredBending {
    MomentCurvature warp, weft;
    PlateBending::Form form = PlateBending::Form::energy;
  };
  std::optional<MeasuredBending> measured_bending;

  struct Damping {
    double mass = 0;         // drag against still air, per mass [1/s]
    double membrane = 1e-3;  // Kelvin–Voigt relaxation time of stretch and in-plane shear [s]
    double bending = 3e-4;   // Kelvin–Voigt relaxation time of bending [s]
  } damping;

  struct Net {                      // the free parameters of the particle net (chapter §3.1)
    double compression_factor = 1;  // D' of a shortened thread (38)
    double shear_factor = 1;        // B' (43)
    bool diagonal_springs = false;  // false: in-plane shear from the difference of a cell's diagonals; true: one spring
                                    // a diagonal as in (43), which also stiffens the threads
    double diagonal_compression_factor = 1;  // B' of the shorter diagonal, with diagonal_springs
  } net;
};

/// A sheet with different threads in warp and weft: E₁ h, E₂ h, G h; bending B_i = E_i h³/12 of strips and G h³/12 of
/// the twist; transverse shear √(E₁ E₂) h / (2 (1 + √(ν₁₂ ν₂₁))), which is that of an isotropic fabric for E₁ = E₂.
/// @throws std::invalid_argument  unless all moduli, h and area_density are positive, 0 ≤ ν₁₂ < 0.5 and ν₁₂ ν₂₁ < 1
[[nodiscard]] Fabric orthotropic_fabric(double warp_modulus, double weft_modulus, double shear_modulus, double poisson,
                                        double thickness, double area_density);

/// Replaces the bending of a fabric by that measured on strips.
///
/// A strip is free to curl across, so what a test of it measures is B_i = E_i I per width (chapter (45), article (31));
/// the sheet, which bends into a cylinder, has D₁₁ = B₁/(1 − ν₁₂ ν₂₁), D₁₂ = ν₁₂ D₂₂ with ν₂₁ = ν₁₂ B₂/B₁ (32), (33).
/// @param warp, weft  B₁, B₂ [N m]
/// @param twist       m₁₂ per engineering twist 2κ₁₂ [N m]; default √(B₁ B₂)/(2 (1 + √(ν₁₂ ν₂₁))), of an isotropic
///                    fabric D (1 − ν)/2
/// @throws std::invalid_argument  unless all are positive and ν₁₂ ν₂₁ < 1
void set_measured_bending(Fabric& fabric, double warp, double weft, std::optional<double> twist = {});

/// Likewise for laws M = f(K) of strips; the rigidities become those at K = 0.
/// @throws std::invalid_argument  as PlateBending does
void set_measured_bending(Fabric& fabric, const Fabric::MeasuredBending& strips);

/// The fabric with its membrane stiffnesses E₁ h, E₂ h, G h and its bending stiffnesses multiplied, whatever its laws
/// are. Transverse shear, weight and relaxation times stay.
/// @throws std::invalid_argument  unless both factors are positive
[[nodiscard]] Fabric scaled(Fabric fabric, double membrane, double bending);

/// The bending of a fabric's sheet.
[[nodiscard]] PlateBending plate_bending(const Fabric& fabric);

/// Membrane stiffness C [N/m], n = C (ε₁₁, ε₂₂, 2ε₁₂) in warp–weft axes: E₁ h/(1 − ν₁₂ ν₂₁) and so on.
[[nodiscard]] Eigen::Matrix3d membrane_stiffness(const Fabric& fabric);

/// Isotropic resultants from E [Pa], ν and h [m]: E h (chapter (38)), G h = E h / (2 (1 + ν)) (40), and
/// E h³ / (12 (1 − ν²)) ((45) with I from (46)).
/// @throws std::invalid_argument  unless E > 0, h > 0, 0 ≤ ν < 0.5, area_density > 0
[[nodiscard]] Fabric isotropic_fabric(double youngs_modulus, double poisson, double thickness, double area_density);

}  // namespace sundrape

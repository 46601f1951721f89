#pragma once
#include <vector>

#include "sundrape/force/shell.hpp"

namespace sundrape {

/// Strains and stress resultants at the centres of a shell's elements, in their warp–weft axes; one row an element.
struct ShellReadings {
  using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  using Rows2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

  Rows3 membrane_strain;  // ε₁₁, ε₂₂, 2ε₁₂
  Rows3 membrane_force;   // n₁₁, n₂₂, n₁₂ [N/m]
  Rows2 shear_strain;     // γ₁, γ₂
  Rows2 shear_force;      // q₁, q₂ [N/m]
  Rows3 curvature;        // κ₁₁, κ₂₂, 2κ₁₂ [1/m]
  Rows3 moment;           // m₁₁, m₂₂, m₁₂ [N]
};

/// Largest principal strain of all rows (ε₁₁, ε₂₂, 2ε₁₂), 0 if none is positive.
[[nodiscard]] double largest_principal_strain(const ShellReadings::Rows3& strains);

/// Reads a shell's deformation as strain gauges would: formulas (3)–(5) and (8)–(10) written out at the centre of each
/// element, apart from the arithmetic that integrates forces. Stresses are without their viscous part.
class ShellGauges {
 public:
  /// @param options  only the measure of curvature and the length of directors count here
  ShellGauges(std::vector<ShellElement> elements, const ShellSection& section, const ShellOptions& options);

  /// @param q  all points: positions and directors [m]
  [[nodiscard]] ShellReadings read(ConstVectorRef q) const;

 private:
  struct Gauge;
  [[nodiscard]] Gauge gauge(const std::array<Vector3, 4>& x, const std::array<Vector3, 4>& t, bool spans) const;

  std::vector<ShellElement> elements_;
  ShellSection section_;
  ShellOptions options_;
};

/// The readings of several parts of a sheet, one after the other.
[[nodiscard]] ShellReadings read(const std::vector<ShellGauges>& parts, ConstVectorRef q);

}  // namespace sundrape

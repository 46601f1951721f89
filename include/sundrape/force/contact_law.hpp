#pragma once

namespace sundrape {

/// Pressure of a surface on what comes near it, against depth d = w − gap: a smoothstep in stiffness.
///
/// With x = d/w:  p = 0 for d ≤ 0,  k w (x³ − x⁴/2) for d < w,  k (d − w/2) beyond. Its slope k (3x² − 2x³) runs from 0
/// to k, so the law is C² at both ends, and the energy C³.
class ContactLaw {
 public:
  /// @param stiffness  k, pressure per depth [N/m³]
  /// @param smoothing  w, distance over which the force sets in [m]
  /// @throws std::invalid_argument  unless both are positive
  ContactLaw(double stiffness, double smoothing);

  [[nodiscard]] double stiffness() const { return stiffness_; }
  [[nodiscard]] double smoothing() const { return smoothing_; }

  /// Pressure p [Pa] ≥ 0, its integral over the depth [J/m²] and its slope dp/dd [N/m³].
  [[nodiscard]] double pressure(double gap) const;
  [[nodiscard]] double energy(double gap) const;
  [[nodiscard]] double slope(double gap) const;
  /// The gap at which the law carries a pressure [m]; the inverse of `pressure` for values > 0.
  [[nodiscard]] double gap_under(double pressure) const;

 private:
  double stiffness_, smoothing_;
};

/// What decides how stiff a contact must be.
struct ContactLoad {
  double weight_per_area;  // of the cloth [N/m²]
  double diagonal;         // of the sheet [m]
  double spread;  // width over which the cloth spreads a load [m]: between contact points, or (B/w)^⅓/8 if larger
};

/// A stiffness that keeps landing cloth from sinking deeper than is allowed [N/m³]:
/// k = 64 · weight_per_area · (diagonal / spread) / penetration.
///
/// Where cloth hangs over an edge, the overhang, at most the diagonal, presses on a strip as wide as `spread`. At the
/// corners of a table threads of both families pull down, and in landing they pull several times their weight: the
/// chapter's tablecloth presses with up to twice its whole weight on one node of 1 cm² (measured on the 4 cm and the
/// 8 cm table with meshes of 21² and 41² nodes), which the factor covers twice over, for finer meshes sink deeper.
/// @param penetration  allowed below the surface [m]
/// @throws std::invalid_argument  unless all are positive
[[nodiscard]] double suggested_stiffness(const ContactLoad& load, double penetration);

}  // namespace sundrape

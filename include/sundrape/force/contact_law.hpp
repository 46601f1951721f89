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
  double edge_length;      // mean cell size [m]
};

/// The stiffness that keeps the penetration under a resting cloth below what is allowed [N/m³]:
/// k = 2 · weight_per_area · (diagonal / edge_length) / penetration.
///
/// Where cloth hangs over an edge the whole overhang rests on one row of nodes: the pressure there is the weight per
/// area times overhang / cell. The diagonal bounds the overhang from above and the factor 2 leaves room for the
/// dynamics of landing.
/// @param penetration  allowed below the surface [m]
/// @throws std::invalid_argument  unless all are positive
[[nodiscard]] double suggested_stiffness(const ContactLoad& load, double penetration);

}  // namespace sundrape

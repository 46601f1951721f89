#pragma once
#include "sundrape/force/contact_law.hpp"

namespace sundrape {

/// Pressure of two layers of cloth on each other against the distance d of their mid-surfaces.
///
/// That of the contact law, set in around the distance h at which they lie on each other, and in its inner half a
/// barrier: with d̂ = h/2,  W = k d̂² (d̂/d − 1)³  for d < d̂, C² there and without bound as d → 0. Cloth is soft enough to
/// rest on each other without it; what is thrown on it at some 10 m/s must not come through.
class ClothLaw {
 public:
  explicit ClothLaw(const ContactLaw& law) : law_(law) {}

  [[nodiscard]] double smoothing() const { return law_.smoothing(); }
  [[nodiscard]] double stiffness() const { return law_.stiffness(); }
  /// Beyond it there is no force [m].
  [[nodiscard]] double reach(double h) const { return h + 0.5 * law_.smoothing(); }

  /// Nearer than this the barrier acts [m].
  [[nodiscard]] static double barrier_begin(double h);

  /// Pressure [Pa] ≥ 0, its integral from d outwards [J/m²], and −dp/dd [N/m³]; d > 0.
  [[nodiscard]] double pressure(double d, double h) const;
  [[nodiscard]] double energy(double d, double h) const;
  [[nodiscard]] double slope(double d, double h) const;

 private:
  [[nodiscard]] double gap(double d, double h) const { return d - h + 0.5 * law_.smoothing(); }

  ContactLaw law_;
};

}  // namespace sundrape

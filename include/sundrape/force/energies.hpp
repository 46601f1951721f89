#pragma once

namespace sundrape {

/// Energies by kind [J].
struct Energies {
  double kinetic = 0, membrane = 0, shear = 0, bending = 0, gravity = 0, contact = 0, load = 0;

  [[nodiscard]] double stored() const { return membrane + shear + bending + gravity + contact + load; }
  [[nodiscard]] double total() const { return kinetic + stored(); }
};

}  // namespace sundrape

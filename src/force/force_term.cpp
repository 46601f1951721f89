#include "sundrape/force/force_term.hpp"

#include <fmt/format.h>

namespace sundrape {

void ForceTerm::add_energies(const State& state, Energies& energies) const {
  switch (kind()) {
    case EnergyKind::membrane:
      energies.membrane += energy(state);
      break;
    case EnergyKind::shear:
      energies.shear += energy(state);
      break;
    case EnergyKind::bending:
      energies.bending += energy(state);
      break;
    case EnergyKind::gravity:
      energies.gravity += energy(state);
      break;
    case EnergyKind::contact:
      energies.contact += energy(state);
      break;
    case EnergyKind::load:
      energies.load += energy(state);
      break;
    case EnergyKind::none:
      break;
  }
}

std::string describe(const Passage& passage) {
  return fmt::format("cloth would pass through cloth, {}, at ({:.4g}, {:.4g}, {:.4g}) m", passage.what,
                     passage.place.x(), passage.place.y(), passage.place.z());
}

}  // namespace sundrape

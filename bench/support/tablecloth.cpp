#include "support/tablecloth.hpp"

#include <fmt/format.h>

#include "sundrape/integrate/default_tolerances.hpp"
#include "sundrape/io/case_reader.hpp"

namespace sundrape {

Tablecloth tablecloth(int nodes, std::vector<std::string> sets) {
  sets.push_back(fmt::format("cloth.cells=[{0}, {0}]", nodes - 1));
  const Case c = read_case(SUNDRAPE_CASES "/tablecloth.toml", sets);
  Tablecloth cloth{.model = build_model(c), .options = {}, .q = {}, .v = {}};
  const double rtol = c.dynamics.rtol;
  const auto defaults = default_tolerances(rtol, cloth.model.size, cloth.model.gravity);
  cloth.options.rtol = rtol;
  cloth.options.atol_position = c.dynamics.atol_position.value_or(defaults.position);
  cloth.options.atol_velocity = c.dynamics.atol_velocity.value_or(defaults.velocity);
  cloth.options.max_order = c.dynamics.max_order;
  cloth.q.resize(cloth.system().unknowns().size());
  cloth.system().unknowns().gather(cloth.model.initial, cloth.q);
  cloth.v = Vector::Zero(cloth.q.size());
  return cloth;
}

std::string undamped() { return "material.damping={ mass = 0, membrane = 0, bending = 0 }"; }

}  // namespace sundrape

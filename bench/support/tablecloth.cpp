#include "support/tablecloth.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sundrape/io/case_reader.hpp"

namespace sundrape {

Tablecloth tablecloth(int nodes, std::vector<std::string> sets) {
  sets.push_back(fmt::format("cloth.cells=[{0}, {0}]", nodes - 1));
  const Case c = read_case(SUNDRAPE_CASES "/tablecloth.toml", sets);
  Tablecloth cloth{.model = build_model(c), .options = {}, .q = {}, .v = {}};
  const double rtol = c.dynamics.rtol;
  const double speed = std::sqrt(cloth.model.gravity * cloth.model.size);
  cloth.options.rtol = rtol;
  cloth.options.atol_position = c.dynamics.atol_position.value_or(0.25 * rtol * cloth.model.size);
  cloth.options.atol_velocity = c.dynamics.atol_velocity.value_or(std::min(0.01, 100 * rtol) * speed);
  cloth.options.max_order = c.dynamics.max_order;
  cloth.q.resize(cloth.system().unknowns().size());
  cloth.system().unknowns().gather(cloth.model.initial, cloth.q);
  cloth.v = Vector::Zero(cloth.q.size());
  return cloth;
}

std::string undamped() { return "material.damping={ mass = 0, membrane = 0, bending = 0 }"; }

}  // namespace sundrape

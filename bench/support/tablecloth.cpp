#include "support/tablecloth.hpp"

#include <fmt/format.h>

#include "sundrape/app/solver_choice.hpp"
#include "sundrape/io/case_reader.hpp"

namespace sundrape {

Tablecloth tablecloth(int nodes, std::vector<std::string> sets) {
  sets.push_back(fmt::format("cloth.cells=[{0}, {0}]", nodes - 1));
  const Case c = read_case(SUNDRAPE_CASES "/tablecloth.toml", sets);
  Tablecloth cloth{.model = build_model(c), .options = {}, .q = {}, .v = {}};
  cloth.options = integrator_options(c, cloth.model);
  cloth.q.resize(cloth.system().unknowns().size());
  cloth.system().unknowns().gather(cloth.model.initial, cloth.q);
  cloth.v = Vector::Zero(cloth.q.size());
  return cloth;
}

std::string undamped() { return "material.damping={ mass = 0, membrane = 0, bending = 0 }"; }

}  // namespace sundrape

#pragma once
#include <string>
#include <vector>

#include "sundrape/app/model.hpp"
#include "sundrape/integrate/integrator.hpp"

namespace sundrape {

/// cases/tablecloth.toml on another mesh, and the integrator's options that a run of it has.
struct Tablecloth {
  CaseModel model;
  IntegratorOptions options;
  Vector q, v;  // unknowns at the start, rows: 3n [m], [m/s]

  [[nodiscard]] const System& system() const { return *model.system; }
};

/// @param nodes  a side
/// @param sets   further settings of the case, as in `sundrape run --set`
/// @throws CaseError
[[nodiscard]] Tablecloth tablecloth(int nodes, std::vector<std::string> sets = {});

/// Settings that take all damping away.
[[nodiscard]] std::string undamped();

}  // namespace sundrape

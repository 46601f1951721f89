#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "sundrape/app/model.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/statics/relaxation.hpp"

namespace sundrape::samples {

/// A small sheet in its plane z = 0 under gravity; `more` are further tables. What stands first in it is line 13.
inline std::string sheet_case(const std::string& more,
                              const std::string& shape = "shape = \"rectangle\"\nsize = [0.08, 0.06]\ncells = [4, 3]") {
  return fmt::format("analysis = \"relaxation\"\n[cloth]\n{}{}{}", shape, R"(
[material]
thickness = "0.5 mm"
density_area = 0.2
youngs_modulus = "1 MPa"
poisson = 0.3
[[load]]
kind = "gravity"
)",
                     more);
}

/// g times 0.2 kg/m² times 8 cm by 6 cm [N].
constexpr double sheet_weight = 9.80665 * 0.2 * 0.08 * 0.06;

inline CaseModel model_of(const std::string& text, const std::filesystem::path& file = "CASE.toml") {
  return build_model(parse_case(text, file));
}

/// Positions in equilibrium, 3N [m].
inline Vector equilibrium(const CaseModel& model, double tolerance) {
  const auto solver = make_linear_solver(SolverKind::cholesky);
  UnseenRelaxation unseen;
  Vector q = model.initial;
  const auto result =
      relax(*model.system, *solver, {.tolerance = tolerance, .first_step = 1e-3, .force_scale = 1}, q, unseen);
  if (result.end != RelaxationEnd::converged) throw std::runtime_error(result.diagnosis);
  return q;
}

}  // namespace sundrape::samples

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/measures.hpp"
#include "sundrape/io/nearest_name.hpp"

namespace sundrape {
namespace {

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char c : name)
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  names.reserve(list.size());
  for (const auto& entry : list) names.push_back(entry.name);
  return names;
}

template <class List>
std::vector<std::string> words_of(const List& list) {
  auto words = names_of(list);
  for (auto& word : words) word = as_word(word);
  return words;
}

/// Names that may stand in the place of a pattern's capitals; or its own text.
std::vector<std::string> accepted(const std::string& part, const std::string& family, const Case& c) {
  if (part == "NAME") return words_of(c.output.probes);
  if (part == "SET") {
    auto names = words_of(c.fixes);
    for (const auto& motion : c.motions) names.push_back(as_word(motion.name));
    return names;
  }
  if (part == "AXIS") {
    if (family == "probe") return {"x", "y", "z", "vx", "vy", "vz"};
    return {"x", "y", "z"};
  }
  if (part == "KIND")
    return {"kinetic", "membrane",   "shear",         "bending",           "gravity",
            "contact", "dissipated", "external_work", "method_dissipated", "total"};
  if (part == "COLUMN") {
    switch (c.analysis) {
      case Analysis::dynamics:
        return names_of(dynamics_step_columns());
      case Analysis::relaxation:
        return names_of(relaxation_step_columns());
      case Analysis::arc_length:
        return names_of(path_step_columns());
    }
  }
  return {part};
}

[[noreturn]] void fail(const std::string& name, const std::string& what, const std::string& written,
                       const std::vector<std::string>& names) {
  const auto near = nearest_name(written, names);
  throw std::invalid_argument(fmt::format("'{}': {}{}; accepted: {}", name, what,
                                          near.empty() ? "" : fmt::format(", did you mean '{}'?", near),
                                          names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

const MeasureInfo& series_info(const std::string& name, const Case& c, bool with_reference) {
  const auto parts = parts_of(name);
  for (const auto& entry : series_catalogue()) {
    const auto pattern = parts_of(entry.name);
    if (pattern.front() != parts.front()) continue;
    bool fits = pattern.size() == parts.size();
    for (std::size_t k = 1; fits && k < parts.size(); ++k) {
      const auto names = accepted(pattern[k], pattern.front(), c);
      fits = std::ranges::find(names, parts[k]) != names.end();
      if (!fits && std::isupper(static_cast<unsigned char>(pattern[k].front())) != 0)
        fail(name, fmt::format("'{}' is not there", parts[k]), parts[k], names);
    }
    if (!fits) continue;
    if (parts.front() == "reference" && !with_reference)
      throw std::invalid_argument(fmt::format("'{}': there is no reference: add [reference] to the study", name));
    return entry;
  }
  const auto known = names_of(series_catalogue());
  fail(name, "no such series", name, known);
}

}  // namespace

std::string as_word(const std::string& name) {
  auto word = name;
  for (char& c : word)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  return word;
}

const std::vector<MeasureInfo>& number_catalogue() {
  static const std::vector<MeasureInfo> all{
      {"nodes", "1", "of the mesh"},
      {"diagonal", "m", "of the cloth's rest shape"},
      {"steps", "1", "accepted steps of the integrator"},
      {"force_evaluations", "1", "evaluations of all forces by the integrator"},
      {"newton_iterations", "1", "iterations of Newton's method"},
      {"error_test_failures", "1", "steps that the error test refused"},
      {"step_solve_failures", "1", "steps that Newton's method could not solve"},
      {"restarts", "1", "restarts of the integrator at events"},
      {"iterations", "1", "steps of a relaxation"},
      {"path_steps", "1", "accepted steps of an equilibrium path"},
      {"factorizations", "1", "matrices factored"},
      {"linear_solves", "1", "linear systems solved"},
      {"linear_iterations", "1", "iterations of the linear solver"},
      {"sensitivity_linear_iterations", "1", "iterations of the linear solver for sensitivities"},
      {"patterns", "1", "changes of the matrices' pattern"},
      {"residual", "1", "out-of-balance force over external force at the end of a relaxation"},
      {"negative_pivots", "1", "of the tangent at the end of a static analysis; 0: a stable equilibrium"},
      {"critical_points", "1", "limit points and bifurcations that a path met"},
      {"load_factor", "1", "where a path ended"},
      {"method_dissipated_J", "J", "energy that the integration method itself lost (gained, if negative)"},
      {"largest_edge_strain", "1", "of a thread segment, over the frames"},
      {"smallest_edge_strain", "1", "of a thread segment, over the frames"},
      {"largest_membrane_strain", "1", "principal strain at the centre of a shell's element, over the frames"},
      {"deepest_penetration_m", "m", "of a contact point into an obstacle, or of cloth into cloth"},
      {"sharpest_bend_deg", "1", "turn of a thread from one edge to the next, in degrees, over the frames"},
      {"cpu_seconds", "s", "processor time", true},
      {"wall_seconds", "s", "wall-clock time", true},
      {"assembly_seconds", "s", "wall-clock time in assembling tangents", true},
      {"factor_seconds", "s", "wall-clock time in factoring", true},
      {"solve_seconds", "s", "wall-clock time in linear solves", true},
      {"sensitivity_matrix_seconds", "s", "wall-clock time in the matrices of sensitivities", true},
  };
  return all;
}

const std::vector<MeasureInfo>& series_catalogue() {
  static const std::vector<MeasureInfo> all{
      {"probe.NAME.AXIS", "m", "place (x, y, z) of a probe, at every step"},
      {"energy.KIND", "J",
       "by the names of /frames/energy, or their mechanical `total`: kinetic and all that is stored"},
      {"reaction.SET.AXIS", "N", "force that the cloth exerts on a fixed or moved set"},
      {"contact.force.AXIS", "N", "sum of the contact forces on the cloth"},
      {"contact.penetration", "m", "deepest, into an obstacle or of cloth into cloth"},
      {"shape.top", "m", "z of the highest node"},
      {"shape.bottom", "m", "z of the lowest node"},
      {"frame.residual", "1", "out-of-balance force over external force"},
      {"step.COLUMN", "", "a column of /steps, in its own unit, SI"},
      {"reference.rms", "m", "RMS distance of the nodes from those of the reference at the same time"},
      {"reference.max", "m", "largest distance of a node from that of the reference at the same time"},
  };
  return all;
}

const MeasureInfo& measure_info(const std::string& name, const Case& c, bool with_reference) {
  if (name.find('.') != std::string::npos) {
    static const MeasureInfo speed{"probe.NAME.AXIS", "m/s", "rate (vx, vy, vz) of a probe, at every step"};
    static const MeasureInfo step_size{"step.COLUMN", "s", "length of the steps"};
    const auto& info = series_info(name, c, with_reference);
    if (info.name == speed.name && parts_of(name).back().starts_with('v')) return speed;
    if (name == "step.step_size" || name == "step.time") return step_size;
    return info;
  }
  const auto& known = number_catalogue();
  const auto found = std::ranges::find(known, name, &MeasureInfo::name);
  if (found == known.end()) fail(name, "no such number", name, names_of(known));
  return *found;
}

}  // namespace sundrape

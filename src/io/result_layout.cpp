#include "sundrape/io/result_layout.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

namespace sundrape {
namespace {

using layout::Meaning;
constexpr std::size_t warning_length = 512;  // bytes
constexpr std::uint64_t expected_steps = 4096;
constexpr std::uint64_t expected_warnings = 16;
constexpr std::uint64_t expected_critical_points = 4;

const std::vector<Meaning>& table() {
  static const std::vector<Meaning> meanings{
      {"/mesh/reference", "m", "rest position of each node"},
      {"/mesh/material", "m", "warp and weft coordinate of each node"},
      {"/mesh/quads", "1", "the four nodes of each quadrilateral, counter-clockwise"},
      {"/mesh/sets/*", "1", "nodes of a named set"},
      {"/obstacles/*/vertices", "m", "vertices of an obstacle's surface, from its place"},
      {"/obstacles/*/triangles", "1", "the three vertices of each triangle of an obstacle's surface"},
      {"/frames/time", "s", "time of each frame; of a relaxation, its pseudo-time"},
      {"/frames/load_factor", "1", "load factor of each frame, in its stage"},
      {"/frames/stage", "1", "stage of loads and motions that each frame is in, from 1 on"},
      {"/frames/position", "m", "position of each node"},
      {"/frames/velocity", "m/s", "velocity of each node"},
      {"/frames/contact_force", "N", "contact force on each node"},
      {"/frames/director", "1", "director of each node"},
      {"/frames/energy_density", "J/m^2",
       "stored energy of membrane, shear and bending over the area at rest, at each node"},
      {"/frames/element/membrane_strain", "1", "membrane strains e11, e22, 2 e12 at the centre of each element"},
      {"/frames/element/membrane_force", "N/m", "membrane forces n11, n22, n12 at the centre of each element"},
      {"/frames/element/shear_strain", "1", "transverse shear strains g1, g2 at the centre of each element"},
      {"/frames/element/shear_force", "N/m", "transverse shear forces q1, q2 at the centre of each element"},
      {"/frames/element/curvature", "1/m", "curvatures k11, k22, 2 k12 at the centre of each element"},
      {"/frames/element/moment", "N", "bending moments m11, m22, m12 per width at the centre of each element"},
      {"/frames/energy/kinetic", "J", "kinetic energy"},
      {"/frames/energy/membrane", "J", "stored energy of stretching along the threads"},
      {"/frames/energy/shear", "J", "stored energy of shear"},
      {"/frames/energy/bending", "J", "stored energy of bending"},
      {"/frames/energy/gravity", "J", "potential energy in the field of gravity"},
      {"/frames/energy/contact", "J", "stored energy of contact"},
      {"/frames/energy/dissipated", "J", "energy turned into heat by damping and friction since the start"},
      {"/frames/energy/external_work", "J",
       "work done on the cloth by loads without an energy and by moved nodes since the start"},
      {"/frames/energy/method_dissipated", "J", "energy lost by the time integration itself since the start"},
      {"/frames/residual", "1", "norm of the out-of-balance force over the norm of the external force"},
      {"/frames/negative_pivots", "1", "negative pivots of the tangent stiffness, 0 where stable; -1: not evaluated"},
      {"/frames/penetration", "m", "deepest penetration into an obstacle, or of cloth into cloth"},
      {"/frames/crossings", "1", "pairs of triangles of the cloth that intersect"},
      {"/frames/contact_force_sum", "N", "sum of the contact forces on the cloth"},
      {"/frames/reaction/*", "N", "force that the cloth exerts on a fixed or moved set"},
      {"/frames/reaction_moment/*", "N m",
       "moment that the cloth exerts on a fixed or moved set, about the mean position of its nodes"},
      {"/frames/obstacle_force/*", "N", "force of an obstacle on the cloth, friction included"},
      {"/frames/obstacle_position/*", "m", "position of an obstacle that moves"},
      {"/frames/obstacle_rotation/*", "1", "rotation matrix of an obstacle that moves, from its shape to the world"},
      {"/sensitivity/*/position", "m", "derivative of each node's position by a parameter; NaN: not known"},
      {"/sensitivity/*/velocity", "m/s", "derivative of each node's velocity by a parameter; NaN: not known"},
      {"/sensitivity/*/probes/*", "m", "derivative of a probed node's position by a parameter; NaN: not known"},
      {"/probes/*/time", "s", "time of every accepted step"},
      {"/probes/*/load_factor", "1", "load factor of every accepted step of an equilibrium path"},
      {"/probes/*/position", "m", "position of the probed node"},
      {"/probes/*/velocity", "m/s", "velocity of the probed node"},
      {"/steps/time", "s", "time at the end of every accepted step; of a relaxation, its pseudo-time"},
      {"/steps/load_factor", "1", "load factor at the end of every accepted step"},
      {"/steps/stage", "1", "stage of loads and motions"},
      {"/steps/arc_length", "1",
       "length of the step: norm of all increments of coordinates over the sheet's size, and of the load factor"},
      {"/steps/halvings", "1", "how often the step was halved because it diverged"},
      {"/steps/step_size", "s", "size of the step"},
      {"/steps/order", "1", "order of the method"},
      {"/steps/newton_iterations", "1", "Newton iterations"},
      {"/steps/linear_iterations", "1", "iterations of the linear solver"},
      {"/steps/error_test_failures", "1", "attempts rejected by the error test"},
      {"/steps/convergence_failures", "1", "attempts that Newton's method gave up"},
      {"/steps/contacts", "1", "pairs of a contact point and an obstacle that press on each other"},
      {"/steps/residual", "1", "norm of the out-of-balance force over the norm of the external force"},
      {"/steps/negative_pivots", "1", "negative pivots of the tangent stiffness; -1: not evaluated"},
      {"/steps/total_energy", "J", "kinetic and stored energy"},
      {"/steps/kinetic_energy", "J", "kinetic energy"},
      {"/iterations/step", "1", "step that the iteration was for, from 1 on, rejected tries included"},
      {"/iterations/iteration", "1", "number of the iteration in its try; 1 is the prediction"},
      {"/iterations/load_factor", "1", "load factor of the iterate"},
      {"/iterations/residual", "1", "norm of the out-of-balance force over the norm of the external force"},
      {"/critical/load_factor", "1", "load factor at which the tangent is singular"},
      {"/critical/uncertainty", "1", "the load factor is known to plus or minus this"},
      {"/critical/stage", "1", "stage of loads and motions"},
      {"/critical/limit_point", "1", "1: the load has an extreme there; 0: the path forks"},
      {"/critical/pivots_before", "1", "negative pivots of the tangent before the point"},
      {"/critical/pivots_after", "1", "negative pivots of the tangent after it"},
      {"/critical/position", "m", "position of each node at the point"},
      {"/critical/mode", "1", "displacements of the nodes in the critical mode, the largest of a node or director 1"},
      {"/warnings", "1", "what the analysis found worth saying"},
  };
  return meanings;
}

bool fits(std::string_view path, std::string_view pattern) {
  const auto star = pattern.find('*');
  if (star == std::string_view::npos) return path == pattern;
  if (!path.starts_with(pattern.substr(0, star))) return false;
  const auto tail = pattern.substr(star + 1), rest = path.substr(star);
  for (std::size_t taken = 1; taken <= rest.size(); ++taken)
    if (fits(rest.substr(taken), tail)) return true;
  return false;
}

Column column(const std::string& path, std::vector<std::uint64_t> row_shape = {},
              hdf5::Element element = hdf5::Element::real64, std::size_t text_length = 0) {
  const auto [pattern, units, description] = layout::meaning(path);
  return {path, element, std::move(row_shape), text_length, std::string(units), std::string(description)};
}

bool counts(std::string_view name) {
  constexpr std::array<std::string_view, 9> names{"order",
                                                  "newton_iterations",
                                                  "linear_iterations",
                                                  "error_test_failures",
                                                  "convergence_failures",
                                                  "contacts",
                                                  "negative_pivots",
                                                  "stage",
                                                  "halvings"};
  return std::ranges::find(names, name) != names.end();
}

std::vector<StepColumn> step_columns(std::initializer_list<const char*> names) {
  std::vector<StepColumn> columns;
  for (const auto* const name : names) columns.push_back(step_column(name));
  return columns;
}

/// In the order in which the writer adds them.
void add_sensitivities(const ResultHeader& header, std::vector<Column>& columns) {
  const auto nodes = static_cast<std::uint64_t>(header.mesh.nodes());
  for (const auto& by : header.sensitivities) {
    const auto group = "/sensitivity/" + layout::link_name(by.parameter);
    const auto add = [&](const std::string& name, std::vector<std::uint64_t> shape) {
      columns.push_back(column(group + name, std::move(shape)));
      if (by.unit != "1") columns.back().units += fmt::format("/({})", by.unit);
    };
    add("/position", {nodes, 3});
    if (header.rate_sensitivities) add("/velocity", {nodes, 3});
    for (const auto& probe : header.probes) add("/probes/" + layout::link_name(probe.name), {3});
  }
}

Series frame_series(const ResultHeader& header) {
  const auto nodes = static_cast<std::uint64_t>(header.mesh.nodes());
  Series frames{.columns = {column(layout::frame_variable_path(header.frame_variable))},
                .expected_rows = header.expected_frames};
  auto& columns = frames.columns;
  if (header.frame_variable == FrameVariable::load_factor)
    columns.push_back(column("/frames/stage", {}, hdf5::Element::int64));
  for (const auto* const name : {"position", "velocity", "contact_force"})
    columns.push_back(column(fmt::format("/frames/{}", name), {nodes, 3}));
  if (header.director) columns.push_back(column("/frames/director", {nodes, 3}));
  columns.push_back(column("/frames/energy_density", {nodes}));
  if (header.element_fields)
    for (const auto& [name, components] : layout::element_fields())
      columns.push_back(column("/frames/element/" + std::string(name),
                               {header.mesh.quads.size(), static_cast<std::uint64_t>(components)}));
  for (const auto& name : layout::energy_names()) columns.push_back(column("/frames/energy/" + name));
  columns.push_back(column("/frames/residual"));
  columns.push_back(column("/frames/negative_pivots", {}, hdf5::Element::int64));
  columns.push_back(column("/frames/penetration"));
  columns.push_back(column("/frames/crossings", {}, hdf5::Element::int64));
  columns.push_back(column("/frames/contact_force_sum", {3}));
  for (const auto& set : header.reaction_sets)
    columns.push_back(column("/frames/reaction/" + layout::link_name(set), {3}));
  for (const auto& set : header.reaction_sets)
    columns.push_back(column("/frames/reaction_moment/" + layout::link_name(set), {3}));
  for (const auto& obstacle : header.obstacles) {
    const auto name = layout::link_name(obstacle.name);
    columns.push_back(column("/frames/obstacle_force/" + name, {3}));
    if (!obstacle.moves) continue;
    columns.push_back(column("/frames/obstacle_position/" + name, {3}));
    columns.push_back(column("/frames/obstacle_rotation/" + name, {3, 3}));
  }
  add_sensitivities(header, columns);
  return frames;
}

Series iteration_series() {
  return {.columns = {column("/iterations/step", {}, hdf5::Element::int64),
                      column("/iterations/iteration", {}, hdf5::Element::int64), column("/iterations/load_factor"),
                      column("/iterations/residual")},
          .expected_rows = expected_steps};
}

Series critical_series(const ResultHeader& header) {
  const auto nodes = static_cast<std::uint64_t>(header.mesh.nodes());
  Series points{.columns = {column("/critical/load_factor"), column("/critical/uncertainty")},
                .expected_rows = expected_critical_points};
  for (const auto* const name : {"stage", "limit_point", "pivots_before", "pivots_after"})
    points.columns.push_back(column(fmt::format("/critical/{}", name), {}, hdf5::Element::int64));
  points.columns.push_back(column("/critical/position", {nodes, 3}));
  points.columns.push_back(column("/critical/mode", {nodes, 3}));
  return points;
}

}  // namespace

std::string to_string(ResultStatus status) {
  constexpr std::array<const char*, 4> names{"running", "done", "failed", "interrupted"};
  return names.at(static_cast<std::size_t>(status));
}

StepColumn step_column(const std::string& name) {
  const auto [path, units, description] = layout::meaning("/steps/" + name);
  return {name, std::string(units), std::string(description), counts(name)};
}

std::vector<StepColumn> dynamics_step_columns() {
  return step_columns({"time", "step_size", "order", "newton_iterations", "linear_iterations", "error_test_failures",
                       "convergence_failures", "contacts"});
}

std::vector<StepColumn> relaxation_step_columns() {
  return step_columns(
      {"time", "step_size", "residual", "newton_iterations", "linear_iterations", "contacts", "negative_pivots"});
}

std::vector<StepColumn> path_step_columns() {
  return step_columns({"load_factor", "stage", "arc_length", "newton_iterations", "halvings", "residual", "contacts",
                       "negative_pivots"});
}

namespace layout {

const std::vector<Meaning>& all() { return table(); }

Meaning meaning(const std::string& path) {
  const auto found = std::ranges::find_if(table(), [&](const Meaning& each) { return fits(path, each.path); });
  if (found == table().end()) throw std::invalid_argument(fmt::format("a result has no dataset {}", path));
  return *found;
}

const std::vector<std::string>& energy_names() {
  static const std::vector<std::string> names{"kinetic", "membrane",   "shear",         "bending",          "gravity",
                                              "contact", "dissipated", "external_work", "method_dissipated"};
  return names;
}

std::vector<double> energy_values(const FrameEnergies& e) {
  return {e.kinetic, e.membrane,   e.shear,         e.bending,          e.gravity,
          e.contact, e.dissipated, e.external_work, e.method_dissipated};
}

const std::vector<std::pair<std::string_view, int>>& element_fields() {
  static const std::vector<std::pair<std::string_view, int>> fields{{"membrane_strain", 3}, {"membrane_force", 3},
                                                                    {"shear_strain", 2},    {"shear_force", 2},
                                                                    {"curvature", 3},       {"moment", 3}};
  return fields;
}

std::vector<const Vector*> element_values(const ElementFields& e) {
  return {&e.membrane_strain, &e.membrane_force, &e.shear_strain, &e.shear_force, &e.curvature, &e.moment};
}

std::string link_name(std::string name) {
  std::ranges::replace(name, '/', '_');
  return name.empty() || name == "." ? "unnamed" : name;
}

std::string frame_variable_path(FrameVariable variable) {
  return variable == FrameVariable::time ? "/frames/time" : "/frames/load_factor";
}

std::vector<Series> series(const ResultHeader& header) {
  std::vector<Series> all(SeriesIndex::count);
  all[SeriesIndex::warnings] = {.columns = {column("/warnings", {}, hdf5::Element::text, warning_length)},
                                .expected_rows = expected_warnings};
  all[SeriesIndex::steps].expected_rows = all[SeriesIndex::probes].expected_rows = expected_steps;
  for (const auto& each : header.step_columns)
    all[SeriesIndex::steps].columns.push_back({"/steps/" + each.name,
                                               each.integer ? hdf5::Element::int64 : hdf5::Element::real64,
                                               {},
                                               0,
                                               each.units,
                                               each.description});
  for (const auto& probe : header.probes) {
    const auto group = "/probes/" + link_name(probe.name);
    all[SeriesIndex::probes].columns.push_back(
        column(group + (header.frame_variable == FrameVariable::time ? "/time" : "/load_factor")));
    all[SeriesIndex::probes].columns.push_back(column(group + "/position", {3}));
    all[SeriesIndex::probes].columns.push_back(column(group + "/velocity", {3}));
  }
  if (header.frame_variable == FrameVariable::load_factor) {
    all[SeriesIndex::iterations] = iteration_series();
    all[SeriesIndex::critical] = critical_series(header);
  }
  all[SeriesIndex::frames] = frame_series(header);
  return all;
}

}  // namespace layout
}  // namespace sundrape

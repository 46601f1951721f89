#include "sundrape/io/result_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/io/result_layout.hpp"

#include "checkpoint_slots.hpp"

namespace sundrape {

ResultReader::ResultReader(const std::filesystem::path& path) : file_(hdf5::File::open(path)) {
  if (file_.text_attribute("/", "format") != "sundrape")
    throw FileError(fmt::format("{}: is an HDF5 file, but no result of sundrape", path.string()));
  const auto version = file_.attribute("/", "format_version");
  const auto* const number = std::get_if<std::int64_t>(&version);
  if (number == nullptr || *number > layout::format_version)
    throw FileError(fmt::format("{}: was written by a newer sundrape ({}) in a layout unknown here", path.string(),
                                file_.text_attribute("/", "sundrape_version", "unknown version")));
  title_ = file_.text_attribute("/", "title");
  model_ = file_.text_attribute("/", "model");
  analysis_ = file_.text_attribute("/", "analysis");
  status_ = file_.text_attribute("/", "status");
  message_ = file_.text_attribute("/", "message");
  version_ = file_.text_attribute("/", "sundrape_version");
  case_text_ = file_.text_attribute("/", "case");
  inputs_ = file_.text_attribute("/", "inputs", "");
  read_mesh();
  if (file_.exists("/frames/load_factor")) frame_variable_ = FrameVariable::load_factor;
  frame_values_ = file_.dataset(layout::frame_variable_path(frame_variable_)).read<double>();
  // the column that counts is published last: it is the shortest
  steps_ = std::numeric_limits<std::size_t>::max();
  for (const auto& name : file_.children("/steps"))
    steps_ = std::min<std::size_t>(steps_, file_.dataset("/steps/" + name).rows());
  if (steps_ == std::numeric_limits<std::size_t>::max()) steps_ = 0;
}

void ResultReader::read_mesh() {
  const auto reference = file_.dataset("/mesh/reference").read<double>();
  for (std::size_t i = 0; i + 2 < reference.size(); i += 3)
    mesh_.reference.emplace_back(reference[i], reference[i + 1], reference[i + 2]);
  const auto material = file_.dataset("/mesh/material").read<double>();
  for (std::size_t i = 0; i + 1 < material.size(); i += 2) mesh_.material.emplace_back(material[i], material[i + 1]);
  const auto quads = file_.dataset("/mesh/quads").read<std::int32_t>();
  for (std::size_t i = 0; i + 3 < quads.size(); i += 4)
    mesh_.quads.push_back({quads[i], quads[i + 1], quads[i + 2], quads[i + 3]});
  for (const auto& name : file_.children("/mesh/sets"))
    mesh_.sets[name] = file_.dataset("/mesh/sets/" + name).read<std::int32_t>();
}

Vector ResultReader::nodal(const std::string& path, std::size_t frame) const {
  if (frame >= frames())
    throw FileError(fmt::format("{}: has {} frames, frame {} was asked for", file_.name(), frames(), frame));
  const auto values = file_.dataset(path).read_rows<double>(frame, 1);
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

bool ResultReader::has_director() const { return file_.exists("/frames/director"); }
bool ResultReader::has_energy_density() const { return file_.exists("/frames/energy_density"); }

std::vector<double> ResultReader::per_frame(const std::string& path) const {
  return file_.dataset(path).read_rows<double>(0, frames());
}

std::vector<Vector3> ResultReader::vectors(const std::string& path, std::size_t rows) const {
  const auto values = file_.dataset(path).read_rows<double>(0, rows);
  std::vector<Vector3> result;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) result.emplace_back(values[i], values[i + 1], values[i + 2]);
  return result;
}

std::map<std::string, std::vector<double>> ResultReader::energies() const {
  std::map<std::string, std::vector<double>> result;
  for (const auto& name : file_.children("/frames/energy")) result[name] = per_frame("/frames/energy/" + name);
  return result;
}

std::vector<double> ResultReader::residual() const { return per_frame("/frames/residual"); }
std::vector<double> ResultReader::penetration() const { return per_frame("/frames/penetration"); }
std::vector<Vector3> ResultReader::contact_force_sum() const { return vectors("/frames/contact_force_sum", frames()); }
std::vector<std::int64_t> ResultReader::negative_pivots() const {
  return file_.dataset("/frames/negative_pivots").read_rows<std::int64_t>(0, frames());
}

std::map<std::string, std::vector<Vector3>> ResultReader::reactions() const { return by_set("/frames/reaction"); }

std::map<std::string, std::vector<Vector3>> ResultReader::reaction_moments() const {
  return by_set("/frames/reaction_moment");
}

std::map<std::string, std::vector<Vector3>> ResultReader::by_set(const std::string& group) const {
  std::map<std::string, std::vector<Vector3>> result;
  for (const auto& set : file_.children(group)) result[set] = vectors(fmt::format("{}/{}", group, set), frames());
  return result;
}

bool ResultReader::has_element_fields() const { return !file_.children("/frames/element").empty(); }

ElementFields ResultReader::element_fields(std::size_t frame) const {
  ElementFields fields;
  const std::array<Vector*, 6> members{&fields.membrane_strain, &fields.membrane_force, &fields.shear_strain,
                                       &fields.shear_force,     &fields.curvature,      &fields.moment};
  for (std::size_t k = 0; k < members.size(); ++k)
    *members[k] = nodal("/frames/element/" + std::string(layout::element_fields()[k].first), frame);
  return fields;
}

std::vector<SensitivityRecord> ResultReader::sensitivities() const {
  std::vector<SensitivityRecord> result;
  for (const auto& name : file_.children("/sensitivity")) {
    const auto group = "/sensitivity/" + name;
    result.push_back({file_.text_attribute(group, "parameter"), std::get<double>(file_.attribute(group, "value")),
                      file_.text_attribute(group, "unit")});
  }
  return result;
}

Vector ResultReader::position_sensitivity(const std::string& parameter, std::size_t frame) const {
  return nodal(fmt::format("/sensitivity/{}/position", layout::link_name(parameter)), frame);
}

std::map<std::string, std::vector<double>> ResultReader::step_columns() const {
  std::map<std::string, std::vector<double>> result;
  for (const auto& name : file_.children("/steps"))
    result[name] = file_.dataset("/steps/" + name).read_rows<double>(0, steps_);
  return result;
}

std::map<std::string, ProbeHistory> ResultReader::probes() const {
  std::map<std::string, ProbeHistory> result;
  const auto names = file_.children("/probes");
  auto rows = std::numeric_limits<std::uint64_t>::max();
  const std::string variable = frame_variable_ == FrameVariable::time ? "/time" : "/load_factor";
  for (const auto& name : names)
    rows = std::min(rows, file_.dataset(fmt::format("/probes/{}{}", name, variable)).rows());
  for (const auto& name : names) {
    const auto group = "/probes/" + name;
    auto& probe = result[name];
    const auto node = file_.attribute(group, "node");
    if (const auto* const number = std::get_if<std::int64_t>(&node)) probe.node = static_cast<int>(*number);
    probe.time = file_.dataset(group + variable).read_rows<double>(0, rows);
    probe.position = vectors(group + "/position", rows);
    probe.velocity = vectors(group + "/velocity", rows);
  }
  return result;
}

std::vector<CriticalRecord> ResultReader::critical_points() const {
  std::vector<CriticalRecord> result;
  if (!file_.exists("/critical/load_factor")) return result;
  const auto load = file_.dataset("/critical/load_factor").read<double>();
  const auto column = [&](const char* name) {
    return file_.dataset(std::string("/critical/") + name).read_rows<std::int64_t>(0, load.size());
  };
  const auto uncertainty = file_.dataset("/critical/uncertainty").read_rows<double>(0, load.size());
  const auto stage = column("stage"), limit = column("limit_point"), before = column("pivots_before"),
             after = column("pivots_after");
  const auto field = [&](const char* name, std::size_t row) {
    const auto values = file_.dataset(std::string("/critical/") + name).read_rows<double>(row, 1);
    return Vector(Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  for (std::size_t k = 0; k < load.size(); ++k)
    result.push_back({.limit_point = limit[k] != 0,
                      .stage = static_cast<int>(stage[k]),
                      .load_factor = load[k],
                      .uncertainty = uncertainty[k],
                      .pivots_before = static_cast<int>(before[k]),
                      .pivots_after = static_cast<int>(after[k]),
                      .position = field("position", k),
                      .mode = field("mode", k)});
  return result;
}

std::vector<Statistic> ResultReader::statistics() const {
  std::vector<Statistic> result;
  const auto descriptions =
      nlohmann::json::parse(file_.text_attribute("/statistics", "descriptions", "{}"), nullptr, false);
  for (const auto& name : file_.attribute_names("/statistics")) {
    if (name == "descriptions") continue;
    auto& each = result.emplace_back();
    each.name = name;
    if (descriptions.is_object()) each.description = descriptions.value(name, "");
    const auto value = file_.attribute("/statistics", name);
    if (const auto* const integer = std::get_if<std::int64_t>(&value)) each.value = *integer;
    if (const auto* const real = std::get_if<double>(&value)) each.value = *real;
    if (const auto* const text = std::get_if<std::string>(&value)) each.value = *text;
  }
  return result;
}

std::vector<std::string> ResultReader::warnings() const {
  const auto dataset = file_.dataset("/warnings");
  return dataset.read_text(0, dataset.rows());
}

std::vector<ObstacleRecord> ResultReader::obstacles() const {
  std::vector<ObstacleRecord> result;
  for (const auto& name : file_.children("/obstacles")) {
    const auto group = "/obstacles/" + name;
    auto& obstacle = result.emplace_back();
    obstacle.name = name;
    obstacle.kind = file_.text_attribute(group, "kind");
    const auto parameters = nlohmann::json::parse(file_.text_attribute(group, "parameters", "{}"), nullptr, false);
    for (const auto& [parameter, values] : parameters.items())  // a rounding that is not known is null
      if (values.is_array() && std::ranges::all_of(values, [](const auto& v) { return v.is_number(); }))
        values.get_to(obstacle.parameters[parameter]);
    const auto position = std::get<std::vector<double>>(file_.attribute(group, "position"));
    obstacle.position = Eigen::Map<const Vector3>(position.data());
    const auto rotation = std::get<std::vector<double>>(file_.attribute(group, "rotation"));
    obstacle.rotation = Eigen::Map<const Matrix3>(rotation.data()).transpose();  // stored by rows
    obstacle.moves = file_.exists("/frames/obstacle_position/" + name);
    if (!file_.exists(group + "/vertices")) continue;
    obstacle.surface.vertices = vectors(group + "/vertices", file_.dataset(group + "/vertices").rows());
    const auto corners = file_.dataset(group + "/triangles").read<std::int32_t>();
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
      obstacle.surface.triangles.push_back({corners[k], corners[k + 1], corners[k + 2]});
  }
  return result;
}

ObstaclePose ResultReader::obstacle_pose(const std::string& obstacle, std::size_t frame) const {
  const auto of = [&](const char* what) { return nodal(fmt::format("/frames/obstacle_{}/{}", what, obstacle), frame); };
  const Vector rotation = of("rotation");
  return {.position = of("position"),
          .rotation = Eigen::Map<const Matrix3>(rotation.data()).transpose(),  // stored by rows
          .force = of("force")};
}

std::optional<Checkpoint> ResultReader::checkpoint() const {
  const auto newest = checkpoint_slots::read_newest(file_);
  if (!newest) return std::nullopt;
  return newest->checkpoint;
}

}  // namespace sundrape

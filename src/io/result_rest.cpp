#include "result_rest.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/io/mesh_difference.hpp"
#include "sundrape/io/result_layout.hpp"

namespace sundrape {
namespace {

constexpr std::size_t status_length = 16, message_length = 1024;  // bytes kept free for what changes in place

template <class T>
void write_table(hdf5::File& file, const std::string& path, hdf5::Element element, std::vector<std::uint64_t> shape,
                 std::span<const T> values) {
  const auto rows = shape.front();
  file.create_dataset(path, {.element = element, .shape = std::move(shape)}).write_rows(0, rows, std::as_bytes(values));
  const auto [pattern, units, description] = layout::meaning(path);
  file.set_attribute(path, "units", std::string(units));
  file.set_attribute(path, "description", std::string(description));
}

void write_mesh(hdf5::File& file, const QuadMesh& mesh) {
  const auto nodes = mesh.reference.size();
  const std::span reference(nodes > 0 ? mesh.reference.front().data() : nullptr, 3 * nodes);
  write_table<double>(file, "/mesh/reference", hdf5::Element::real64, {nodes, 3}, reference);
  const std::span material(nodes > 0 ? mesh.material.front().data() : nullptr, 2 * nodes);
  write_table<double>(file, "/mesh/material", hdf5::Element::real64, {nodes, 2}, material);
  const std::span quads(mesh.quads.empty() ? nullptr : mesh.quads.front().data(), 4 * mesh.quads.size());
  write_table<int>(file, "/mesh/quads", hdf5::Element::int32, {mesh.quads.size(), 4}, quads);
  file.create_group("/mesh/sets");
  for (const auto& [name, set] : mesh.sets)
    write_table<int>(file, "/mesh/sets/" + layout::link_name(name), hdf5::Element::int32, {set.size()}, set);
}

void write_obstacles(hdf5::File& file, const std::vector<ObstacleRecord>& obstacles) {
  file.create_group("/obstacles");
  for (const auto& obstacle : obstacles) {
    auto group = "/obstacles/" + layout::link_name(obstacle.name);
    for (int again = 2; file.exists(group); ++again)
      group = fmt::format("/obstacles/{} {}", layout::link_name(obstacle.name), again);
    file.create_group(group);
    file.set_attribute(group, "kind", obstacle.kind);
    file.set_attribute(group, "parameters", nlohmann::json(obstacle.parameters).dump());
    file.set_attribute(group, "position", std::vector<double>(obstacle.position.begin(), obstacle.position.end()));
    file.set_attribute(group, "friction", obstacle.friction);
    file.set_attribute(group, "moves", std::int64_t{obstacle.moves ? 1 : 0});
    if (const auto& [vertices, triangles] = obstacle.surface; !vertices.empty()) {
      write_table<double>(file, group + "/vertices", hdf5::Element::real64, {vertices.size(), 3},
                          {vertices.front().data(), 3 * vertices.size()});
      write_table<int>(file, group + "/triangles", hdf5::Element::int32, {triangles.size(), 3},
                       {triangles.front().data(), 3 * triangles.size()});
    }
    const Matrix3 rows = obstacle.rotation.transpose();  // Eigen stores columns, readers expect rows
    file.set_attribute(group, "rotation", std::vector<double>(rows.data(), rows.data() + 9));
  }
}

void write_statistics(hdf5::File& file, const std::vector<Statistic>& statistics) {
  file.create_group("/statistics");
  nlohmann::json descriptions = nlohmann::json::object();
  for (const auto& each : statistics) {
    std::visit([&](const auto& value) { file.set_attribute("/statistics", each.name, value); }, each.value);
    descriptions[each.name] = each.description;
  }
  file.set_attribute("/statistics", "descriptions", descriptions.dump());
}

}  // namespace

void ResultRest::write_status(hdf5::File& file) const {
  file.set_fixed_text("/", "status", to_string(status), status_length);
  file.set_fixed_text("/", "message", message, message_length);
  file.flush();
}

void ResultRest::write(hdf5::File& file) const {
  file.set_attribute("/", "format", std::string("sundrape"));
  file.set_attribute("/", "format_version", std::int64_t{layout::format_version});
  file.set_attribute("/", "sundrape_version", header.version);
  file.set_attribute("/", "title", header.title);
  file.set_attribute("/", "model", header.model);
  file.set_attribute("/", "analysis", header.analysis);
  file.set_attribute("/", "case", header.case_text);
  file.set_attribute("/", "inputs", header.inputs);
  write_status(file);
  write_mesh(file, header.mesh);
  write_obstacles(file, header.obstacles);
  write_statistics(file, statistics);
  for (const auto& by : header.sensitivities) {
    const auto group = "/sensitivity/" + layout::link_name(by.parameter);
    file.create_group(group);
    file.set_attribute(group, "parameter", by.parameter);
    file.set_attribute(group, "value", by.value);
    file.set_attribute(group, "unit", by.unit);
  }
  for (const auto& probe : header.probes) {
    const auto group = "/probes/" + layout::link_name(probe.name);
    file.create_group(group);
    file.set_attribute(group, "node", std::int64_t{probe.node});
  }
  if (checkpoint && finished) checkpoint_slots::create_single(file, *checkpoint);
  if (checkpoint && !finished) checkpoint_slots::create(file, *checkpoint);
}

std::string mesh_difference(const QuadMesh& a, const QuadMesh& b, double tolerance) {
  if (a.nodes() != b.nodes()) return fmt::format("the meshes have {} and {} nodes", a.nodes(), b.nodes());
  if (a.quads != b.quads) return "the meshes have different quads";
  Vector3 low = Vector3::Constant(1e300), high = -low;
  double largest = 0;
  for (std::size_t i = 0; i < a.reference.size(); ++i) {
    low = low.cwiseMin(a.reference[i]);
    high = high.cwiseMax(a.reference[i]);
    largest = std::max(largest, (a.reference[i] - b.reference[i]).norm());
  }
  if (a.nodes() > 0 && !(largest <= tolerance * (high - low).norm()))
    return fmt::format("the rest positions differ by up to {:.3g} m", largest);
  return {};
}

}  // namespace sundrape

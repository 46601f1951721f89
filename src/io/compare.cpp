#include "sundrape/io/compare.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/io/mesh_difference.hpp"

namespace sundrape {
namespace {

double rest_diagonal(const QuadMesh& mesh) {
  Vector3 low = mesh.reference.at(0), high = low;
  for (const auto& x : mesh.reference) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

Vector node_distances(const Vector& a, const Vector& b) { return (a - b).reshaped(3, a.size() / 3).colwise().norm(); }

Comparison::Distance distance(const Vector& a, const Vector& b) {
  const Vector each = node_distances(a, b);
  return {.rms = std::sqrt(each.squaredNorm() / static_cast<double>(each.size())), .max = each.maxCoeff()};
}

/// Positions at a time within the frames, linear between two of them.
Vector position_at(const ResultReader& result, double variable) {
  const auto& values = result.frame_values();
  const auto next = std::ranges::lower_bound(values, variable);
  const auto after = static_cast<std::size_t>(std::distance(values.begin(), next == values.end() ? next - 1 : next));
  if (after == 0 || values[after] <= variable) return result.position(after);
  const double weight = (variable - values[after - 1]) / (values[after] - values[after - 1]);
  return (1 - weight) * result.position(after - 1) + weight * result.position(after);
}

std::map<std::string, double> last_energies(const ResultReader& result) {
  std::map<std::string, double> last;
  for (const auto& [name, values] : result.energies()) last[name] = values.back();
  return last;
}

Comparison::Series series(const ResultReader& a, const ResultReader& b) {
  Comparison::Series result;
  // static analyses number their frames by a pseudo-time, which means nothing from one run to the next
  if (a.frame_variable() != b.frame_variable() || a.analysis() != b.analysis() || a.analysis() == "relaxation")
    return result;
  const double slack = 1e-9 * std::abs(b.frame_values().back());  // equal up to round-off
  const double first = b.frame_values().front() - slack, last = b.frame_values().back() + slack;
  for (std::size_t f = 0; f < a.frames(); ++f) {
    const double variable = a.frame_values()[f];
    if (variable < first || variable > last) continue;
    result.variable.push_back(variable);
    result.distance.push_back(distance(a.position(f), position_at(b, variable)));
  }
  return result;
}

}  // namespace

Comparison compare(const ResultReader& a, const ResultReader& b) {
  for (const auto* const each : {&a, &b})
    if (each->frames() == 0) throw FileError(fmt::format("{}: holds no frames to compare", each->file().name()));
  if (const auto difference = mesh_difference(a.mesh(), b.mesh()); !difference.empty())
    throw FileError(fmt::format("{}: cannot be compared with {}: {}", a.file().name(), b.file().name(), difference));

  Comparison result;
  result.a = a.file().name();
  result.b = b.file().name();
  result.diagonal = rest_diagonal(a.mesh());
  result.last_a = a.frame_values().back();
  result.last_b = b.frame_values().back();
  const auto position_a = a.position(a.frames() - 1), position_b = b.position(b.frames() - 1);
  result.last = distance(position_a, position_b);
  Eigen::Index farthest = 0;
  node_distances(position_a, position_b).maxCoeff(&farthest);
  result.farthest_node = static_cast<int>(farthest);
  result.energy_a = last_energies(a);
  result.energy_b = last_energies(b);
  result.series = series(a, b);
  return result;
}

nlohmann::json to_json(const Comparison& c) {
  nlohmann::json energies = nlohmann::json::object();
  for (const auto& [name, value] : c.energy_a)
    if (const auto other = c.energy_b.find(name); other != c.energy_b.end())
      energies[name] = {{"a", value}, {"b", other->second}, {"difference", other->second - value}};
  std::vector<double> rms, max;
  for (const auto& each : c.series.distance) {
    rms.push_back(each.rms);
    max.push_back(each.max);
  }
  return {{"a", c.a},
          {"b", c.b},
          {"diagonal", c.diagonal},
          {"last_frame",
           {{"a", c.last_a},
            {"b", c.last_b},
            {"rms", c.last.rms},
            {"max", c.last.max},
            {"rms_over_diagonal", c.last.rms / c.diagonal},
            {"max_over_diagonal", c.last.max / c.diagonal},
            {"farthest_node", c.farthest_node}}},
          {"energies", energies},
          {"series", {{"variable", c.series.variable}, {"rms", rms}, {"max", max}}}};
}

std::string to_text(const Comparison& c) {
  auto text = fmt::format("{} at {:g} against {} at {:g}\n", c.a, c.last_a, c.b, c.last_b);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  RMS distance  {:.4e} m  {:.4f} % of the diagonal\n", c.last.rms,
                 100 * c.last.rms / c.diagonal);
  fmt::format_to(out, "  max distance  {:.4e} m  {:.4f} % of the diagonal, at node {}\n", c.last.max,
                 100 * c.last.max / c.diagonal, c.farthest_node);
  fmt::format_to(out, "  energy [J]              a             b    difference\n");
  for (const auto& [name, value] : c.energy_a)
    if (const auto other = c.energy_b.find(name); other != c.energy_b.end())
      fmt::format_to(out, "  {:<17} {:>12.5e}  {:>12.5e}  {:>12.5e}\n", name, value, other->second,
                     other->second - value);
  if (c.series.variable.empty()) return text;
  fmt::format_to(out, "  frame at      RMS [m]      max [m]\n");
  for (std::size_t i = 0; i < c.series.variable.size(); ++i)
    fmt::format_to(out, "  {:<9.6g}  {:>11.4e}  {:>11.4e}\n", c.series.variable[i], c.series.distance[i].rms,
                   c.series.distance[i].max);
  return text;
}

}  // namespace sundrape

#include "sundrape/io/result_info.hpp"

#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sundrape {

nlohmann::json info_json(const ResultReader& result) {
  nlohmann::json info{
      {"file", result.file().name()},  {"title", result.title()},   {"model", result.model()},
      {"analysis", result.analysis()}, {"status", result.status()}, {"sundrape_version", result.version()},
      {"case", result.case_text()},    {"steps", result.steps()},   {"warnings", result.warnings()}};
  if (!result.message().empty()) info["message"] = result.message();
  const auto& mesh = result.mesh();
  info["mesh"] = {{"nodes", mesh.nodes()}, {"quads", mesh.quads.size()}, {"sets", nlohmann::json::object()}};
  for (const auto& [name, set] : mesh.sets) info["mesh"]["sets"][name] = set.size();
  info["frames"] = {{"count", result.frames()},
                    {"variable", result.frame_variable() == FrameVariable::time ? "time" : "load_factor"}};
  info["checkpoint"] = result.checkpoint().has_value();
  info["statistics"] = nlohmann::json::object();
  for (const auto& each : result.statistics())
    std::visit([&](const auto& value) { info["statistics"][each.name] = value; }, each.value);
  info["obstacles"] = nlohmann::json::object();
  for (const auto& each : result.obstacles())
    info["obstacles"][each.name] = {{"kind", each.kind}, {"parameters", each.parameters}};
  for (const auto& by : result.sensitivities())
    info["sensitivities"][by.parameter] = {{"value", by.value}, {"unit", by.unit}};
  info["probes"] = nlohmann::json::object();
  for (const auto& [name, probe] : result.probes()) {
    info["probes"][name]["node"] = probe.node;
    if (!probe.position.empty())
      info["probes"][name]["last_position"] =
          std::vector<double>(probe.position.back().begin(), probe.position.back().end());
  }
  if (result.frames() == 0) return info;

  auto& frames = info["frames"];
  frames["first"] = result.frame_values().front();
  frames["last"] = result.frame_values().back();
  auto& last = info["last_frame"];
  for (const auto& [name, values] : result.energies()) last["energy"][name] = values.back();
  last["residual"] = result.residual().back();
  last["negative_pivots"] = result.negative_pivots().back();
  last["penetration"] = result.penetration().back();
  const auto vector = [](const Vector3& value) { return std::vector<double>(value.begin(), value.end()); };
  last["contact_force_sum"] = vector(result.contact_force_sum().back());
  for (const auto& [set, forces] : result.reactions()) last["reaction"][set] = vector(forces.back());
  for (const auto& [set, moments] : result.reaction_moments()) last["reaction_moment"][set] = vector(moments.back());
  return info;
}

std::string info_text(const ResultReader& result) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}\n  {} ({} model, {}), sundrape {}\n", result.file().name(), result.title(), result.model(),
                 result.analysis(), result.version());
  fmt::format_to(out, "  status      {}{}{}\n", result.status(), result.message().empty() ? "" : ": ",
                 result.message());
  fmt::format_to(out, "  mesh        {} nodes, {} quads\n", result.mesh().nodes(), result.mesh().quads.size());
  for (const auto& each : result.obstacles()) fmt::format_to(out, "  obstacle    {} ({})\n", each.name, each.kind);
  for (const auto& [name, probe] : result.probes())
    fmt::format_to(out, "  probe       {} at node {}\n", name, probe.node);
  for (const auto& by : result.sensitivities())
    fmt::format_to(out, "  sensitivity by {} at {:.6g} {}\n", by.parameter, by.value, by.unit);
  const bool time = result.frame_variable() == FrameVariable::time;
  fmt::format_to(out, "  frames      {}", result.frames());
  if (result.frames() > 0)
    fmt::format_to(out, ", {} {:g} to {:g}{}", time ? "time" : "load factor", result.frame_values().front(),
                   result.frame_values().back(), time ? " s" : "");
  fmt::format_to(out, "\n  steps       {}\n  checkpoint  {}\n", result.steps(),
                 result.checkpoint() ? "yes: --resume goes on from it" : "none");
  if (result.frames() > 0) {
    text += "  last frame\n";
    for (const auto& [name, values] : result.energies())
      fmt::format_to(out, "    {:<18} {:>13.6e} J\n", name, values.back());
    fmt::format_to(out, "    {:<18} {:>13.6e}\n", "residual", result.residual().back());
    fmt::format_to(out, "    {:<18} {:>13.6e} m\n", "penetration", result.penetration().back());
    if (const auto pivots = result.negative_pivots().back(); pivots >= 0)
      fmt::format_to(out, "    {:<18} {}\n", "negative pivots", pivots);
  }
  const auto statistics = result.statistics();
  if (!statistics.empty()) text += "  statistics\n";
  for (const auto& each : statistics)
    std::visit(
        [&](const auto& value) { fmt::format_to(out, "    {:<24} {}  {}\n", each.name, value, each.description); },
        each.value);
  for (const auto& warning : result.warnings()) fmt::format_to(out, "  warning: {}\n", warning);
  return text;
}

}  // namespace sundrape

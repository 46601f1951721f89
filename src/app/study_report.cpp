#include "sundrape/app/study_report.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace sundrape {
namespace {

std::string joined(const std::vector<std::string>& parts, const char* by) {
  return fmt::format("{}", fmt::join(parts, by));
}

bool is_group_axis(const Study& study, std::size_t axis) {
  return std::ranges::find(study.group_axes, axis) != study.group_axes.end();
}

/// The values of the axes within a group that make a run: "3", or "(3, 0.1)" where there are several.
std::string run_label(const Study& study, std::size_t run) {
  std::vector<std::string> values;
  const auto chosen = study.combination(run);
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (!is_group_axis(study, a)) values.push_back(study.axes[a].values[chosen[a]]);
  return values.size() == 1 ? values.front() : fmt::format("({})", joined(values, ", "));
}

std::string run_labels(const Study& study, const std::vector<std::size_t>& runs) {
  std::vector<std::string> labels;
  for (const auto run : runs) labels.push_back(run_label(study, run));
  return joined(labels, " ");
}

std::vector<std::string> axis_keys(const Study& study, bool of_groups) {
  std::vector<std::string> keys;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (is_group_axis(study, a) == of_groups) keys.push_back(study.axes[a].key);
  return keys;
}

std::vector<std::string> group_values(const Study& study, const StudyGroup& group) {
  std::vector<std::string> values;
  for (std::size_t k = 0; k < study.group_axes.size(); ++k)
    values.push_back(study.axes[study.group_axes[k]].values[group.values[k]]);
  return values;
}

std::string stability(const EndState& end) {
  return end.negative_pivots ? fmt::format("{}", *end.negative_pivots) : "?";
}

std::string neutral_text(const NeutralMotions& neutral) {
  std::vector<std::string> parts;
  for (const auto& slide : neutral.slides)
    parts.push_back(fmt::format("a slide along ({:.3g}, {:.3g})", slide.x(), slide.y()));
  if (neutral.pivot) parts.emplace_back("a turn about the vertical");
  return parts.empty() ? "" : " and " + joined(parts, ", ");
}

/// Names of probes over all runs.
std::vector<std::string> probe_names(const StudyOutcome& outcome) {
  for (const auto& end : outcome.ends) {
    if (!end) continue;
    std::vector<std::string> names;
    for (const auto& [name, place] : end->probes) names.push_back(name);
    return names;
  }
  return {};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string inside;
  for (const char c : text) inside += c == '"' ? "\"\"" : std::string(1, c);
  return '"' + inside + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::vector<std::string> safe;
  for (const auto& cell : cells) safe.push_back(quoted(cell));
  return joined(safe, ",") + "\n";
}

std::vector<std::string> measure_names(const StudyOutcome& outcome) {
  std::vector<std::string> names{"total_energy_J", "negative_pivots", "residual"};
  for (const auto& probe : probe_names(outcome))
    for (const char* axis : {"x", "y", "z"}) names.push_back(fmt::format("{}.{}_m", probe, axis));
  return names;
}

std::vector<std::string> measures(const StudyOutcome& outcome, const EndState& end) {
  std::vector<std::string> cells{fmt::format("{:.10g}", end.total_energy),
                                 fmt::format("{}", end.negative_pivots.value_or(-1)),
                                 fmt::format("{:.3g}", end.residual)};
  for (const auto& probe : probe_names(outcome))
    for (int k = 0; k < 3; ++k) cells.push_back(fmt::format("{:.9g}", end.probes.at(probe)[k]));
  return cells;
}

/// Group and drape of a run, from 0; none of one that failed.
struct Place {
  std::size_t group = 0;
  std::optional<std::size_t> drape;
};

Place place_of(const StudyOutcome& outcome, std::size_t run) {
  for (std::size_t g = 0; g < outcome.groups.size(); ++g)
    for (std::size_t d = 0; d < outcome.groups[g].drapes.size(); ++d)
      if (std::ranges::binary_search(outcome.groups[g].drapes[d].members, run)) return {g, d};
  return {};
}

const char* status_text(BatchStatus status) { return status == BatchStatus::done ? "done" : "failed"; }

void group_text(const Study& study, const StudyOutcome& outcome, const StudyGroup& group, std::string& text) {
  const auto out = std::back_inserter(text);
  std::vector<std::string> labels;
  const auto values = group_values(study, group);
  for (std::size_t k = 0; k < values.size(); ++k)
    labels.push_back(fmt::format("{} = {}", study.axes[study.group_axes[k]].key, values[k]));
  fmt::format_to(out, "\n{}{}{} of {} runs", joined(labels, ", "), labels.empty() ? "" : ": ",
                 group.drapes.size() == 1 ? "one drape" : fmt::format("{} drapes", group.drapes.size()),
                 group.runs.size());
  if (group.runs.empty()) {
    text += "\n";
    return;
  }
  fmt::format_to(out, ", up to {} {} of the case{}; nearer than {:g} % of the diagonal, {:.4g} m, is the same\n",
                 group.symmetries, group.symmetries == 1 ? "symmetry" : "symmetries", neutral_text(group.neutral),
                 100 * study.same_shape, study.same_shape * group.diagonal);
  fmt::format_to(out, "drape  count    energy [J]  pivots  residual  spread [%]");
  for (const auto& probe : probe_names(outcome)) fmt::format_to(out, "  {:^27}", probe + " [m]");
  fmt::format_to(out, "  {}\n", joined(axis_keys(study, false), ", "));
  for (std::size_t d = 0; d < group.drapes.size(); ++d) {
    const auto& drape = group.drapes[d];
    const auto& end = *outcome.ends[drape.representative];
    fmt::format_to(out, "{:>5}  {:>5}  {:>12.6e}  {:>6}  {:>8.1e}  {:>10.3f}", d + 1, drape.members.size(),
                   end.total_energy, stability(end), end.residual, 100 * drape.spread / group.diagonal);
    for (const auto& [name, place] : end.probes)
      fmt::format_to(out, "  ({:>8.5f} {:>8.5f} {:>8.5f})", place.x(), place.y(), place.z());
    fmt::format_to(out, "  {}\n", run_labels(study, drape.members));
  }
}

}  // namespace

std::string study_text(const Study& study, const StudyOutcome& outcome) {
  const auto done = std::ranges::count(outcome.runs, BatchStatus::done, &BatchOutcome::status);
  auto text = fmt::format("{}: {} of {} runs are done\n", study.title, done, outcome.runs.size());
  for (const auto& group : outcome.groups) group_text(study, outcome, group, text);
  for (std::size_t run = 0; run < outcome.runs.size(); ++run)
    if (outcome.runs[run].status != BatchStatus::done)
      text += fmt::format("failed: {}: {}\n", outcome.names[run], outcome.runs[run].message);
  return text;
}

std::string drapes_csv(const Study& study, const StudyOutcome& outcome) {
  auto header = axis_keys(study, true);
  for (const auto* name : {"drape", "count", "runs", "spread_m"}) header.emplace_back(name);
  const auto names = measure_names(outcome);
  header.insert(header.end(), names.begin(), names.end());
  auto text = csv_line(header);
  for (const auto& group : outcome.groups)
    for (std::size_t d = 0; d < group.drapes.size(); ++d) {
      const auto& drape = group.drapes[d];
      auto cells = group_values(study, group);
      for (auto& cell : {fmt::format("{}", d + 1), fmt::format("{}", drape.members.size()),
                         run_labels(study, drape.members), fmt::format("{:.6g}", drape.spread)})
        cells.push_back(cell);
      const auto numbers = measures(outcome, *outcome.ends[drape.representative]);
      cells.insert(cells.end(), numbers.begin(), numbers.end());
      text += csv_line(cells);
    }
  return text;
}

std::string runs_csv(const Study& study, const StudyOutcome& outcome) {
  std::vector<std::string> header{"run"};
  for (const auto& axis : study.axes) header.push_back(axis.key);
  header.insert(header.end(), {"status", "drape"});
  const auto names = measure_names(outcome);
  header.insert(header.end(), names.begin(), names.end());
  auto text = csv_line(header);
  for (std::size_t run = 0; run < outcome.runs.size(); ++run) {
    std::vector<std::string> cells{outcome.names[run]};
    const auto chosen = study.combination(run);
    for (std::size_t a = 0; a < study.axes.size(); ++a) cells.push_back(study.axes[a].values[chosen[a]]);
    const auto place = place_of(outcome, run);
    cells.emplace_back(status_text(outcome.runs[run].status));
    cells.push_back(place.drape ? fmt::format("{}", *place.drape + 1) : "");
    const auto numbers =
        outcome.ends[run] ? measures(outcome, *outcome.ends[run]) : std::vector<std::string>(names.size());
    cells.insert(cells.end(), numbers.begin(), numbers.end());
    text += csv_line(cells);
  }
  return text;
}

nlohmann::json study_json(const Study& study, const StudyOutcome& outcome, const std::filesystem::path& folder) {
  const auto file = [&](std::size_t run) { return outcome.runs[run].result.lexically_relative(folder).string(); };
  nlohmann::json json{{"format", "sundrape study"},      {"title", study.title},
                      {"study", study.file.string()},    {"case", study.case_file.string()},
                      {"same_shape", study.same_shape},  {"group_by", axis_keys(study, true)},
                      {"axes", nlohmann::json::array()}, {"groups", nlohmann::json::array()},
                      {"runs", nlohmann::json::array()}};
  for (const auto& axis : study.axes) json["axes"].push_back({{"key", axis.key}, {"values", axis.values}});
  for (const auto& group : outcome.groups) {
    nlohmann::json entry{{"values", group_values(study, group)},
                         {"diagonal_m", group.diagonal},
                         {"symmetries", group.symmetries},
                         {"neutral_slides", group.neutral.slides.size()},
                         {"neutral_turn", group.neutral.pivot.has_value()},
                         {"drapes", nlohmann::json::array()}};
    for (const auto& drape : group.drapes) {
      std::vector<std::string> members;
      for (const auto run : drape.members) members.push_back(outcome.names[run]);
      nlohmann::json d = to_json(*outcome.ends[drape.representative]);
      d.update({{"count", drape.members.size()},
                {"runs", members},
                {"labels", run_labels(study, drape.members)},
                {"spread_m", drape.spread},
                {"representative", file(drape.representative)}});
      entry["drapes"].push_back(std::move(d));
    }
    json["groups"].push_back(std::move(entry));
  }
  for (std::size_t run = 0; run < outcome.runs.size(); ++run) {
    nlohmann::json entry = outcome.ends[run] ? to_json(*outcome.ends[run]) : nlohmann::json::object();
    const auto chosen = study.combination(run);
    for (std::size_t a = 0; a < study.axes.size(); ++a)
      entry["values"][study.axes[a].key] = study.axes[a].values[chosen[a]];
    const auto place = place_of(outcome, run);
    if (place.drape) entry.update({{"group", place.group}, {"drape", *place.drape + 1}});
    entry.update({{"name", outcome.names[run]},
                  {"result", file(run)},
                  {"status", status_text(outcome.runs[run].status)},
                  {"reused", outcome.runs[run].reused}});
    if (!outcome.runs[run].message.empty()) entry["message"] = outcome.runs[run].message;
    json["runs"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace sundrape

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sundrape/app/study_report.hpp"

#include "study_labels.hpp"

namespace sundrape {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string inside;
  for (const char c : text) inside += c == '"' ? "\"\"" : std::string(1, c);
  return '"' + inside + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::vector<std::string> safe;
  safe.reserve(cells.size());
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

/// What begins a line of a table of runs.
std::vector<std::string> run_header(const Study& study) {
  std::vector<std::string> header{"run"};
  for (const auto& axis : study.axes) header.push_back(axis.name);
  header.emplace_back("status");
  return header;
}

std::vector<std::string> run_cells(const Study& study, const StudyOutcome& outcome, std::size_t run) {
  std::vector<std::string> cells{outcome.names[run]};
  for (std::size_t a = 0; a < study.axes.size(); ++a) cells.push_back(study.value(run, a).label);
  cells.emplace_back(status_text(outcome.runs[run].status));
  return cells;
}

/// Columns of the outputs that are timings, or of those that are not, with their units: "height [cm]".
void add_output_names(const Study& study, bool timings, std::vector<std::string>& header) {
  for (const auto& output : study.outputs)
    if (is_timing(output) == timings)
      header.push_back(output.unit.empty() ? output.name : fmt::format("{} [{}]", output.name, output.unit));
}

void add_outputs(const Study& study, const StudyOutcome& outcome, std::size_t run, bool timings,
                 std::vector<std::string>& cells) {
  for (std::size_t k = 0; k < study.outputs.size(); ++k) {
    if (is_timing(study.outputs[k]) != timings) continue;
    const double value = outcome.table.values[run][k];
    cells.push_back(std::isfinite(value) ? fmt::format("{}", value) : "");
  }
}

}  // namespace

std::string drapes_csv(const Study& study, const StudyOutcome& outcome) {
  auto header = axis_names(study, true);
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
  auto header = run_header(study);
  add_output_names(study, false, header);
  const auto names = measure_names(outcome);
  if (study.branches) {
    header.emplace_back("drape");
    header.insert(header.end(), names.begin(), names.end());
  }
  auto text = csv_line(header);
  for (std::size_t run = 0; run < outcome.runs.size(); ++run) {
    auto cells = run_cells(study, outcome, run);
    add_outputs(study, outcome, run, false, cells);
    if (study.branches) {
      const auto place = place_of(outcome, run);
      cells.push_back(place.drape ? fmt::format("{}", *place.drape + 1) : "");
      const auto numbers =
          outcome.ends[run] ? measures(outcome, *outcome.ends[run]) : std::vector<std::string>(names.size());
      cells.insert(cells.end(), numbers.begin(), numbers.end());
    }
    text += csv_line(cells);
  }
  return text;
}

bool has_timings(const Study& study) { return std::ranges::any_of(study.outputs, is_timing); }

std::string timings_csv(const Study& study, const StudyOutcome& outcome) {
  auto header = run_header(study);
  add_output_names(study, true, header);
  auto text = csv_line(header);
  for (std::size_t run = 0; run < outcome.runs.size(); ++run) {
    auto cells = run_cells(study, outcome, run);
    add_outputs(study, outcome, run, true, cells);
    text += csv_line(cells);
  }
  return text;
}

}  // namespace sundrape

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "sundrape/app/study_report.hpp"

#include "study_labels.hpp"

namespace sundrape {
namespace {

std::string stability(const EndState& end) {
  return end.negative_pivots ? fmt::format("{}", *end.negative_pivots) : "?";
}

std::string neutral_text(const NeutralMotions& neutral) {
  std::vector<std::string> parts;
  parts.reserve(neutral.slides.size() + 1);
  for (const auto& slide : neutral.slides)
    parts.push_back(fmt::format("a slide along ({:.3g}, {:.3g})", slide.x(), slide.y()));
  if (neutral.pivot) parts.emplace_back("a turn about the vertical");
  return parts.empty() ? "" : " and " + joined(parts, ", ");
}

/// Between the members of most and of least energy [J].
double energy_range(const StudyOutcome& outcome, const Drape& drape) {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto run : drape.members) most = std::max(most, outcome.ends[run]->total_energy);
  return most - outcome.ends[drape.representative]->total_energy;
}

void group_text(const Study& study, const StudyOutcome& outcome, const StudyGroup& group, std::string& text) {
  const auto out = std::back_inserter(text);
  std::vector<std::string> labels;
  const auto values = group_values(study, group);
  for (std::size_t k = 0; k < values.size(); ++k)
    labels.push_back(fmt::format("{} = {}", study.axes[study.branches->group_axes[k]].name, values[k]));
  fmt::format_to(out, "\n{}{}{} of {} run{}", joined(labels, ", "), labels.empty() ? "" : ": ",
                 group.drapes.size() == 1 ? "one drape" : fmt::format("{} drapes", group.drapes.size()),
                 group.runs.size(), group.runs.size() == 1 ? "" : "s");
  if (group.runs.empty()) {
    text += "\n";
    return;
  }
  fmt::format_to(out, ", up to {} {} of the case{}; nearer than {:g} % of the diagonal, {:.4g} m, is the same\n",
                 group.symmetries, group.symmetries == 1 ? "symmetry" : "symmetries", neutral_text(group.neutral),
                 100 * study.branches->same_shape, study.branches->same_shape * group.diagonal);
  fmt::format_to(out, "drape  count    energy [J]  pivots  residual  spread [%]  energies [%]");
  for (const auto& probe : probe_names(outcome)) fmt::format_to(out, "  {:^27}", probe + " [m]");
  fmt::format_to(out, "  {}\n", joined(axis_names(study, false), ", "));
  for (std::size_t d = 0; d < group.drapes.size(); ++d) {
    const auto& drape = group.drapes[d];
    const auto& end = *outcome.ends[drape.representative];
    fmt::format_to(out, "{:>5}  {:>5}  {:>12.6e}  {:>6}  {:>8.1e}  {:>10.3f}  {:>12.3f}", d + 1, drape.members.size(),
                   end.total_energy, stability(end), end.residual, 100 * drape.spread / group.diagonal,
                   100 * energy_range(outcome, drape) / std::abs(end.total_energy));
    for (const auto& [name, place] : end.probes)
      fmt::format_to(out, "  ({:>8.5f} {:>8.5f} {:>8.5f})", place.x(), place.y(), place.z());
    fmt::format_to(out, "  {}\n", run_labels(study, drape.members));
  }
}

/// Outputs of the first runs; the rest is in the file.
void table_text(const Study& study, const StudyOutcome& outcome, std::string& text) {
  if (study.outputs.empty()) return;
  constexpr std::size_t most_lines = 40;
  std::vector<std::vector<std::string>> cells(1);
  for (const auto& axis : study.axes) cells.front().push_back(axis.name);
  for (const auto& output : study.outputs)
    cells.front().push_back(output.unit.empty() ? output.name : fmt::format("{} [{}]", output.name, output.unit));
  for (std::size_t run = 0; run < std::min(outcome.runs.size(), most_lines); ++run) {
    auto& line = cells.emplace_back();
    for (std::size_t a = 0; a < study.axes.size(); ++a) line.push_back(study.value(run, a).label);
    for (const double value : outcome.table.values[run])
      line.push_back(std::isfinite(value) ? fmt::format("{:.6g}", value) : "-");
  }
  for (const auto& line : cells) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      std::size_t width = 0;
      for (const auto& other : cells) width = std::max(width, other[k].size());
      text += fmt::format("{}{:>{}}", k == 0 ? "" : "  ", line[k], width);
    }
    text += '\n';
  }
  if (outcome.runs.size() > most_lines) text += fmt::format("... {} runs in all\n", outcome.runs.size());
}

}  // namespace

std::string study_text(const Study& study, const StudyOutcome& outcome) {
  const auto done = std::ranges::count(outcome.runs, BatchStatus::done, &BatchOutcome::status);
  auto text = fmt::format("{}: {} of {} runs are done\n", study.title, done, outcome.runs.size());
  table_text(study, outcome, text);
  for (const auto& group : outcome.groups) group_text(study, outcome, group, text);
  for (std::size_t run = 0; run < outcome.runs.size(); ++run)
    if (outcome.runs[run].status != BatchStatus::done)
      text += fmt::format("failed: {}: {}\n", outcome.names[run], outcome.runs[run].message);
  if (outcome.reference && outcome.reference->status != BatchStatus::done)
    text += fmt::format("failed: the reference: {}\n", outcome.reference->message);
  for (const auto& problem : outcome.table.problems) text += fmt::format("no number: {}\n", problem);
  return text;
}

}  // namespace sundrape

#include "study_labels.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sundrape {

std::string joined(const std::vector<std::string>& parts, const char* by) {
  return fmt::format("{}", fmt::join(parts, by));
}

bool is_group_axis(const Study& study, std::size_t axis) {
  return study.branches && std::ranges::find(study.branches->group_axes, axis) != study.branches->group_axes.end();
}

std::string run_label(const Study& study, std::size_t run) {
  std::vector<std::string> values;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (!is_group_axis(study, a)) values.push_back(study.value(run, a).label);
  return values.size() == 1 ? values.front() : fmt::format("({})", joined(values, ", "));
}

std::string run_labels(const Study& study, const std::vector<std::size_t>& runs) {
  std::vector<std::string> labels;
  labels.reserve(runs.size());
  for (const auto run : runs) labels.push_back(run_label(study, run));
  return joined(labels, " ");
}

std::vector<std::string> axis_names(const Study& study, bool of_groups) {
  std::vector<std::string> names;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (is_group_axis(study, a) == of_groups) names.push_back(study.axes[a].name);
  return names;
}

std::vector<std::string> group_values(const Study& study, const StudyGroup& group) {
  std::vector<std::string> values;
  for (std::size_t k = 0; k < group.values.size(); ++k)
    values.push_back(study.axes[study.branches->group_axes[k]].values[group.values[k]].label);
  return values;
}

std::vector<std::string> probe_names(const StudyOutcome& outcome) {
  for (const auto& end : outcome.ends) {
    if (!end) continue;
    std::vector<std::string> names;
    for (const auto& [name, place] : end->probes) names.push_back(name);
    return names;
  }
  return {};
}

DrapePlace place_of(const StudyOutcome& outcome, std::size_t run) {
  for (std::size_t g = 0; g < outcome.groups.size(); ++g)
    for (std::size_t d = 0; d < outcome.groups[g].drapes.size(); ++d)
      if (std::ranges::binary_search(outcome.groups[g].drapes[d].members, run)) return {g, d};
  return {};
}

const char* status_text(BatchStatus status) { return status == BatchStatus::done ? "done" : "failed"; }

}  // namespace sundrape

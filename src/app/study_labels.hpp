#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sundrape/app/study_outcome.hpp"

namespace sundrape {

/// Words that the reports of a study share.
[[nodiscard]] std::string joined(const std::vector<std::string>& parts, const char* by);
[[nodiscard]] bool is_group_axis(const Study& study, std::size_t axis);
/// The values of the axes within a group that make a run: "3", or "(3, 0.1)" where there are several.
[[nodiscard]] std::string run_label(const Study& study, std::size_t run);
[[nodiscard]] std::string run_labels(const Study& study, const std::vector<std::size_t>& runs);
/// Names of the axes that make groups, or of the others.
[[nodiscard]] std::vector<std::string> axis_names(const Study& study, bool of_groups);
/// Values of the axes that make groups.
[[nodiscard]] std::vector<std::string> group_values(const Study& study, const StudyGroup& group);
[[nodiscard]] std::vector<std::string> probe_names(const StudyOutcome& outcome);
[[nodiscard]] const char* status_text(BatchStatus status);

/// Group and drape of a run, from 0; no drape of one that failed.
struct DrapePlace {
  std::size_t group = 0;
  std::optional<std::size_t> drape;
};
[[nodiscard]] DrapePlace place_of(const StudyOutcome& outcome, std::size_t run);

}  // namespace sundrape

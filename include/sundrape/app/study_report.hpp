#pragma once
#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "sundrape/app/study_outcome.hpp"

namespace sundrape {

/// The table of drapes for people, and runs that failed with their reasons.
[[nodiscard]] std::string study_text(const Study& study, const StudyOutcome& outcome);
/// The table of drapes, one line each, SI.
[[nodiscard]] std::string drapes_csv(const Study& study, const StudyOutcome& outcome);
/// One line a run: values of the axes, status, drape and measures, SI; for tables and plots over parameters.
[[nodiscard]] std::string runs_csv(const Study& study, const StudyOutcome& outcome);
/// All of it. @param folder  that file names count from
[[nodiscard]] nlohmann::json study_json(const Study& study, const StudyOutcome& outcome,
                                        const std::filesystem::path& folder);

}  // namespace sundrape

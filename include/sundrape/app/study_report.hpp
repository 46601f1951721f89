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
/// One line a run: values of the axes, status, outputs but for timings in their units; and of studies that sort drapes
/// the drape and its measures, SI.
[[nodiscard]] std::string runs_csv(const Study& study, const StudyOutcome& outcome);
/// Whether any output is one of timing.
[[nodiscard]] bool has_timings(const Study& study);
/// Like runs_csv, of the outputs that are about the computation: two runs of a study never agree in them.
[[nodiscard]] std::string timings_csv(const Study& study, const StudyOutcome& outcome);
/// Axes, runs and outputs but for timings as HDF5 (docs/studies.md): bit-identical whenever the results are.
/// @throws FileError
void write_study_file(const std::filesystem::path& path, const Study& study, const StudyOutcome& outcome);
/// All of it. @param folder  that file names count from
[[nodiscard]] nlohmann::json study_json(const Study& study, const StudyOutcome& outcome,
                                        const std::filesystem::path& folder);

}  // namespace sundrape

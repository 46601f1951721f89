#pragma once
#include <filesystem>
#include <optional>

#include "sundrape/app/executor.hpp"
#include "sundrape/app/run.hpp"

namespace sundrape {

/// What the command line asks of a study.
struct StudyOptions {
  std::filesystem::path study_file;
  std::optional<std::filesystem::path> folder;  // default: the study's name, in the current folder
  ExecutorOptions executor = {};
  int retries = 2;  // of a run whose process or machine was lost
  Verbosity verbosity = Verbosity::normal;
};

/// Runs a study's case for every combination of its axes' values, sorts the end states into drapes, prints them and
/// writes FOLDER/study.json, study.csv and drapes.csv; results are FOLDER/runs/*.h5.
/// @return failed if a run failed, with everything written all the same; interrupted after Ctrl-C, with nothing but the
///         results so far, which the next time go on
/// @throws CaseError, FileError, std::system_error
[[nodiscard]] ExitStatus run_study(const StudyOptions& options);

}  // namespace sundrape

#include "sundrape/app/study_run.hpp"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/app/model.hpp"
#include "sundrape/app/study_outcome.hpp"
#include "sundrape/app/study_report.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_reader.hpp"

#include "write_text.hpp"

namespace sundrape {
namespace {

/// Reads every run's case and builds the first one. What the case says to a value becomes what the study's line says.
void require_settings(const Study& study) {
  for (std::size_t run = 0; run < study.runs(); ++run) {
    try {
      const Case c = read_case(study.case_file, study.settings(run));
      if (run == 0) (void)build_model(c);
    } catch (const CaseError& problem) {
      const auto chosen = study.combination(run);
      for (std::size_t a = 0; a < study.axes.size(); ++a) {
        const auto& axis = study.axes[a];
        if (problem.file() == fmt::format("--set {}={}", axis.key, axis.values[chosen[a]]))
          throw CaseError(axis.source, fmt::format("{} = {}: {}", axis.key, axis.values[chosen[a]], problem.message()));
      }
      throw;
    }
  }
}

}  // namespace

ExitStatus run_study(const StudyOptions& options) {
  const Study study = read_study(options.study_file);
  require_settings(study);
  const auto folder = options.folder.value_or(options.study_file.stem());
  auto names = run_names(study);
  require_comparable_runs(study, names);
  std::vector<BatchRun> runs;
  for (std::size_t run = 0; run < study.runs(); ++run) runs.push_back({names[run], study.settings(run)});
  auto outcomes = run_batch(
      runs,
      {.case_file = study.case_file, .folder = folder / "runs", .jobs = options.jobs, .verbosity = options.verbosity});
  const auto count = [&](BatchStatus status) { return std::ranges::count(outcomes, status, &BatchOutcome::status); };
  if (count(BatchStatus::interrupted) > 0) {
    fmt::print(stderr, "{}: interrupted: {} of {} runs are done; the same command goes on with the others\n",
               options.study_file.string(), count(BatchStatus::done), outcomes.size());
    return ExitStatus::interrupted;
  }
  const bool failed = count(BatchStatus::failed) > 0;
  const auto outcome = study_outcome(study, std::move(names), std::move(outcomes));
  write_text(folder / "study.json", study_json(study, outcome, folder).dump(2) + "\n");
  write_text(folder / "study.csv", runs_csv(study, outcome));
  write_text(folder / "drapes.csv", drapes_csv(study, outcome));
  if (options.verbosity != Verbosity::quiet) {
    std::cout << study_text(study, outcome);
    fmt::print("a picture of every drape: python3 -m sundrape_postproc drapes {} -o {}\n", folder.string(),
               (folder / "drapes.png").string());
  }
  return failed ? ExitStatus::failed : ExitStatus::done;
}

}  // namespace sundrape

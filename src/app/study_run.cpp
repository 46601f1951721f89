#include "sundrape/app/study_run.hpp"

#include <algorithm>
#include <iostream>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/app/end_state.hpp"
#include "sundrape/app/study_outcome.hpp"
#include "sundrape/app/study_report.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/io/mesh_difference.hpp"

#include "write_text.hpp"

namespace sundrape {
namespace {

constexpr const char* reference_name = "reference";  // of its result; names of runs have a "="

/// In a handler: what the case says to a value becomes what the study's line says.
[[noreturn]] void rethrow(const Study& study, std::size_t run, const CaseError& problem) {
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    for (const auto& setting : study.value(run, a).settings)
      if (problem.file() == "--set " + setting) {
        const auto equals = setting.find('=');
        throw CaseError(study.axes[a].source, fmt::format("{} = {}: {}", setting.substr(0, equals),
                                                          setting.substr(equals + 1), problem.message()));
      }
  throw;
}

/// Why two runs' ends cannot be held against each other; empty if they can.
std::string difference(const CaseModel& a, const CaseModel& b) {
  if (a.has_directors() != b.has_directors()) return "one is a particle net, the other one a shell";
  return mesh_difference(a.mesh, b.mesh, but_for_waviness);
}

/// Reads every run's case and builds its model, so that what is wrong is said before any of them runs.
/// @throws CaseError  also on different meshes, or a net and a shell, in one group of drapes
void require_runs(const Study& study, const std::vector<std::string>& names) {
  std::map<std::vector<std::size_t>, std::pair<std::size_t, CaseModel>> first;  // run and model, by group
  for (std::size_t run = 0; run < study.runs(); ++run) {
    try {
      const Case c = read_case(study.case_file, study.settings(run));
      require_outputs(study, c);
      auto model = weighing_model(c);
      if (!study.branches) continue;
      const auto group = study.group_of(run);
      const auto found = first.find(group);
      if (found == first.end()) {
        first.emplace(group, std::pair(run, std::move(model)));
        continue;
      }
      const auto& [earlier, other] = found->second;
      if (const auto why = difference(other, model); !why.empty())
        throw CaseError(study.file.string(), 0, "branches.group_by",
                        fmt::format("{} and {} cannot be compared: {}; name the axis that makes the difference",
                                    names[earlier], names[run], why));
    } catch (const CaseError& problem) {
      rethrow(study, run, problem);
    }
  }
}

/// What people want to know when it is done.
void say(const Study& study, const StudyOutcome& outcome, const std::filesystem::path& folder) {
  std::cout << study_text(study, outcome);
  if (!study.outputs.empty()) fmt::print("the table: {}\n", (folder / "study.csv").string());
  if (!study.figures.empty())
    fmt::print("its figures: python3 -m sundrape_postproc study {} -o {}\n", folder.string(),
               (folder / "figures").string());
  if (study.branches)
    fmt::print("a picture of every drape: python3 -m sundrape_postproc drapes {} -o {}\n", folder.string(),
               (folder / "drapes.png").string());
}

}  // namespace

ExitStatus run_study(const StudyOptions& options) {
  Study study = read_study(options.study_file);
  const auto folder = options.folder.value_or(options.study_file.stem());
  auto names = run_names(study);
  require_runs(study, names);
  complete_units(study, read_case(study.case_file, study.settings(0)));
  std::vector<BatchRun> runs;
  for (std::size_t run = 0; run < study.runs(); ++run) runs.push_back({names[run], study.settings(run)});
  if (study.reference) runs.push_back({reference_name, study.reference_settings()});
  auto outcomes = run_batch(runs, {.case_file = study.case_file,
                                   .folder = folder / "runs",
                                   .executor = options.executor,
                                   .retries = options.retries,
                                   .resume = study.resume,
                                   .verbosity = options.verbosity});
  const auto count = [&](BatchStatus status) { return std::ranges::count(outcomes, status, &BatchOutcome::status); };
  if (count(BatchStatus::interrupted) > 0) {
    fmt::print(stderr, "{}: interrupted: {} of {} runs are done; the same command goes on with the others\n",
               options.study_file.string(), count(BatchStatus::done), outcomes.size());
    return ExitStatus::interrupted;
  }
  const bool failed = count(BatchStatus::failed) > 0;  // also the reference
  std::optional<BatchOutcome> reference;
  if (study.reference) {
    reference = std::move(outcomes.back());
    outcomes.pop_back();
  }
  const auto outcome =
      study_outcome(study, std::move(names), std::move(outcomes), std::move(reference), options.executor.jobs);
  write_text(folder / "study.json", study_json(study, outcome, folder).dump(2) + "\n");
  write_text(folder / "study.csv", runs_csv(study, outcome));
  write_study_file(folder / "study.h5", study, outcome);
  if (has_timings(study)) write_text(folder / "timings.csv", timings_csv(study, outcome));
  if (study.branches) write_text(folder / "drapes.csv", drapes_csv(study, outcome));
  if (options.verbosity != Verbosity::quiet) say(study, outcome, folder);
  return failed ? ExitStatus::failed : ExitStatus::done;
}

}  // namespace sundrape

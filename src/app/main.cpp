#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "sundrape/app/check.hpp"
#include "sundrape/app/crosscheck.hpp"
#include "sundrape/app/fit_run.hpp"
#include "sundrape/app/run.hpp"
#include "sundrape/app/study_run.hpp"
#include "sundrape/export/export_result.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/compare.hpp"
#include "sundrape/io/file_error.hpp"
#include "sundrape/io/result_info.hpp"
#include "sundrape/version.hpp"

namespace {

using sundrape::ExitStatus;

constexpr const char* set_help = "replace or add a key of the case, e.g. --set cloth.cells=[40,40]; repeatable";

/// The command line: one subcommand a verb, each with the action that it stands for.
class CommandLine {
 public:
  CommandLine() {
    app_.set_version_flag("--version", "sundrape " + sundrape::version());
    app_.require_subcommand(1);
    app_.footer(
        "Exit status: 0 done, 1 the analysis failed, 2 bad command line or case, 3 file trouble, 130 interrupted after "
        "a checkpoint.");
    add_run();
    add_check();
    add_info();
    add_compare();
    add_export();
    add_study();
    add_crosscheck();
    add_fit();
  }

  int main(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& asked) {
      return app_.exit(asked);
    } catch (const CLI::ParseError& problem) {
      fmt::print(stderr, "sundrape: {}; see sundrape --help\n", problem.what());
      return static_cast<int>(ExitStatus::bad_input);
    }
    return static_cast<int>(status_);
  }

 private:
  void add_run() {
    auto* verb = app_.add_subcommand("run", "Run one case, whichever analysis it names, and write its result");
    verb->add_option("CASE", run_.case_file, "case file (TOML)")->required();
    verb->add_option("-o,--output", run_.output,
                     "result file (HDF5); default: the case's name with .h5, in the current folder");
    verb->add_option("--set", run_.sets, set_help)->allow_extra_args(false);
    verb->add_option("--resume", run_.resume,
                     "go on from the checkpoint of an earlier result; without -o that file is continued");
    verb->add_option("--threads", run_.threads, "threads for assembly; more than one pays from some 10,000 nodes on")
        ->check(CLI::Range(1, 1024));
    verb->add_option("--summary", run_.summary, "write totals, final energies, extremes and times to this JSON file");
    verb->add_option("--wait", run_.wait, "how long to wait for another process that is writing this result [s]")
        ->check(CLI::NonNegativeNumber);
    verb->add_flag("--force", run_.overwrite, "overwrite an existing result");
    auto* quiet = verb->add_flag("--quiet", quiet_, "print nothing but errors");
    verb->add_flag("-v,--verbose", verbose_, "print progress more often")->excludes(quiet);
    verb->callback([this] {
      if (quiet_) run_.verbosity = sundrape::Verbosity::quiet;
      if (verbose_) run_.verbosity = sundrape::Verbosity::verbose;
      status_ = sundrape::run_case(run_);
    });
  }

  void add_check() {
    auto* verb = app_.add_subcommand(
        "check", "Parse a case, print every resolved value in SI and estimate its size; runs nothing");
    verb->add_option("CASE", run_.case_file, "case file (TOML)")->required();
    verb->add_option("--set", run_.sets, set_help)->allow_extra_args(false);
    verb->callback([this] { std::cout << sundrape::check_case(run_.case_file, run_.sets); });
  }

  void add_info() {
    auto* verb =
        app_.add_subcommand("info", "Say what is in a result: case, mesh, frames, energies, statistics, warnings");
    verb->add_option("RESULT", a_, "result file (HDF5)")->required();
    verb->add_flag("--json", json_, "as JSON");
    verb->callback([this] {
      const sundrape::ResultReader result(a_);
      std::cout << (json_ ? sundrape::info_json(result).dump(2) + "\n" : sundrape::info_text(result));
    });
  }

  void add_compare() {
    auto* verb =
        app_.add_subcommand("compare", "Compare two results on the same mesh: node distances, energies, time series");
    verb->add_option("A", a_, "result file (HDF5)")->required();
    verb->add_option("B", b_, "result file (HDF5)")->required();
    verb->add_flag("--json", json_, "as JSON");
    verb->callback([this] {
      const auto comparison = sundrape::compare(sundrape::ResultReader(a_), sundrape::ResultReader(b_));
      std::cout << (json_ ? sundrape::to_json(comparison).dump(2) + "\n" : sundrape::to_text(comparison));
    });
  }

  void add_export() {
    auto* verb = app_.add_subcommand("export", "Write a result in the format of another program");
    verb->add_option("RESULT", export_.result, "result file (HDF5)")->required();
    verb->add_option(
            "-o,--output", export_.output,
            fmt::format("file to write; its ending says the format: {}", fmt::join(sundrape::export_formats(), " ")))
        ->required();
    verb->add_option("--frames", export_.frames,
                     "some of the frames, first:end:step as in Python, e.g. ::2, -10: or 5; default: all")
        ->allow_extra_args(false);
    verb->add_flag("!--no-obstacles", export_.obstacles, "the cloth alone");
    verb->add_flag("--quiet", quiet_, "print nothing but errors");
    verb->callback([this] { status_ = run_export(); });
  }

  ExitStatus run_export() {
    try {
      const auto written = sundrape::export_result(export_);
      if (quiet_) return ExitStatus::done;
      std::cout << "wrote " << written.front().string();
      if (written.size() > 3) std::cout << " to " << written.back().string() << ", " << written.size() << " files";
      if (written.size() <= 3)
        for (std::size_t k = 1; k < written.size(); ++k) std::cout << " and " << written[k].string();
      std::cout << '\n';
      return ExitStatus::done;
    } catch (const std::invalid_argument& problem) {
      fmt::print(stderr, "sundrape export: {}\n", problem.what());
      return ExitStatus::bad_input;
    }
  }

  void add_study() {
    auto* verb =
        app_.add_subcommand("study", "Run one case along axes of its keys, and sort where the runs end into drapes");
    verb->add_option("STUDY", study_.study_file, "study file (TOML)")->required();
    verb->add_option("-o,--output", study_.folder,
                     "folder of the results; finished ones in it are used again; default: the study's name");
    verb->add_option("--jobs", study_.executor.jobs, "runs at a time; default: one a processor")
        ->check(CLI::Range(1, 1024));
    const std::map<std::string, sundrape::ExecutorKind> kinds{{"local", sundrape::ExecutorKind::local},
                                                              {"slurm", sundrape::ExecutorKind::slurm},
                                                              {"dask", sundrape::ExecutorKind::dask}};
    verb->add_option("--executor", study_.executor.kind,
                     "where runs are carried out: local (default), slurm (job arrays) or dask (distributed)")
        ->transform(CLI::CheckedTransformer(kinds))
        ->option_text("local|slurm|dask");
    verb->add_option("--slurm-options", study_.executor.slurm_options,
                     "of sbatch, in one word: \"--partition=x --time=1:00:00\"");
    verb->add_option("--dask-scheduler", study_.executor.dask_scheduler,
                     "address of a Dask scheduler; default: $DASK_SCHEDULER_ADDRESS, or workers on this machine");
    verb->add_option("--retries", study_.retries, "times that a run is tried again whose process or machine was lost")
        ->check(CLI::Range(0, 100));
    verb->add_flag("--quiet", quiet_, "print nothing but errors");
    verb->callback([this] {
      if (quiet_) study_.verbosity = sundrape::Verbosity::quiet;
      try {
        status_ = sundrape::run_study(study_);
      } catch (const std::invalid_argument& problem) {
        fmt::print(stderr, "sundrape study: {}\n", problem.what());
        status_ = ExitStatus::bad_input;
      }
    });
  }

  void add_crosscheck() {
    auto* verb = app_.add_subcommand(
        "crosscheck", "Run one case by every method that finds equilibria, and say how far apart they end");
    verb->add_option("CASE", crosscheck_.case_file, "case file (TOML)")->required();
    verb->add_option("-o,--output", crosscheck_.folder,
                     "folder of the results; finished ones in it are used again; default: the case's name and "
                     "-crosscheck");
    verb->add_option("--set", crosscheck_.sets, set_help)->allow_extra_args(false);
    verb->add_option("--methods", crosscheck_.methods, "some of them, with commas; default: all")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(sundrape::crosscheck_method_names()));
    verb->add_option("--jobs", crosscheck_.jobs, "runs at a time; default: one a processor")
        ->check(CLI::Range(1, 1024));
    verb->add_flag("--quiet", quiet_, "print nothing but errors");
    verb->callback([this] {
      if (quiet_) crosscheck_.verbosity = sundrape::Verbosity::quiet;
      status_ = sundrape::run_crosscheck(crosscheck_);
    });
  }

  void add_fit() {
    auto* verb =
        app_.add_subcommand("fit", "Identify numbers of a case, such as a bending rigidity, from measurements");
    verb->add_option("FIT", fit_.fit_file, "fit file (TOML)")->required();
    verb->add_option("-o,--output", fit_.folder, "folder of the results; default: the fit's name");
    verb->add_option("--threads", fit_.threads, "threads for assembly")->check(CLI::Range(1, 1024));
    verb->add_flag("--quiet", quiet_, "print nothing but errors");
    verb->callback([this] {
      if (quiet_) fit_.verbosity = sundrape::Verbosity::quiet;
      status_ = sundrape::run_fit(fit_);
    });
  }

  CLI::App app_{"sundrape integrates cloth in time as the mechanical system it is", "sundrape"};
  sundrape::RunOptions run_;
  sundrape::StudyOptions study_;
  sundrape::CrosscheckOptions crosscheck_;
  sundrape::FitOptions fit_;
  sundrape::ExportOptions export_;
  std::string a_, b_;
  bool json_ = false, quiet_ = false, verbose_ = false;
  ExitStatus status_ = ExitStatus::done;
};

}  // namespace

int main(int argc, char** argv) {
  const auto fail = [](const std::exception& problem, ExitStatus status) {
    std::cout.flush();
    fmt::print(stderr, "{}\n", problem.what());
    return static_cast<int>(status);
  };
  try {
    return CommandLine().main(argc, argv);
  } catch (const sundrape::CaseError& problem) {
    return fail(problem, ExitStatus::bad_input);
  } catch (const sundrape::FileError& problem) {
    return fail(problem, ExitStatus::file_trouble);
  } catch (const std::system_error& problem) {
    return fail(problem, ExitStatus::file_trouble);
  } catch (const std::exception& problem) {
    return fail(problem, ExitStatus::failed);
  }
}

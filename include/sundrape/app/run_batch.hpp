#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sundrape/app/executor.hpp"
#include "sundrape/app/run.hpp"

namespace sundrape {

/// One run of a case among many.
struct BatchRun {
  std::string name;               // of its result, NAME.h5, and its log, NAME.log
  std::vector<std::string> sets;  // settings, as of --set
};

struct BatchOptions {
  std::filesystem::path case_file;
  std::filesystem::path folder;  // where results go; made if it is not there
  ExecutorOptions executor = {};
  int retries = 2;     // of a run whose process or machine was lost
  bool resume = true;  // go on from checkpoints; otherwise such runs begin anew
  Verbosity verbosity = Verbosity::normal;
};

enum class BatchStatus { done, failed, interrupted };

struct BatchOutcome {
  std::filesystem::path result;
  BatchStatus status = BatchStatus::interrupted;
  bool reused = false;  // from an earlier batch
  std::string message;  // why it failed
};

/// Runs a case many times, each in a process of its own: one that fails or crashes takes no other with it. One that is
/// lost (killed, or with its machine) is tried again; one whose analysis failed is not, since it would fail again.
///
/// A result that is done, and of the same case with the same settings, is used as it is; one that was interrupted or
/// killed goes on from its checkpoint, where it may. Ctrl-C has every run write its checkpoint and stop. Progress goes
/// to stdout.
/// @return one a run, in their order
/// @throws CaseError          settings that the case does not take; before anything runs
/// @throws FileError, std::system_error  the folder cannot be written, or another batch is at work in it
/// @throws std::invalid_argument  as make_executor
[[nodiscard]] std::vector<BatchOutcome> run_batch(const std::vector<BatchRun>& runs, const BatchOptions& options);

}  // namespace sundrape

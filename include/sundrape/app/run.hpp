#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sundrape {

enum class Verbosity { quiet, normal, verbose };

/// What the command line asks of one run.
struct RunOptions {
  std::filesystem::path case_file;
  std::vector<std::string> sets;
  std::optional<std::filesystem::path> output;   // default: the case's name with .h5, in the current folder
  std::optional<std::filesystem::path> resume;   // a result with a checkpoint
  std::optional<std::filesystem::path> summary;  // JSON
  int threads = 1;
  double wait = 0;  // for another process that is writing the result [s]
  bool overwrite = false;
  Verbosity verbosity = Verbosity::normal;
};

/// Exit statuses of the command line.
enum class ExitStatus : int { done = 0, failed = 1, bad_input = 2, file_trouble = 3, interrupted = 130 };

/// Runs one case, whichever analysis it names, and writes its result.
/// @throws CaseError, FileError
[[nodiscard]] ExitStatus run_case(const RunOptions& options);

}  // namespace sundrape

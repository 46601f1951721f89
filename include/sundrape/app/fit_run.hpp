#pragma once
#include <filesystem>
#include <optional>

#include "sundrape/app/run.hpp"

namespace sundrape {

/// What the command line asks of a fit.
struct FitOptions {
  std::filesystem::path fit_file;
  std::optional<std::filesystem::path> folder;  // default: the fit's name, in the current folder
  int threads = 1;
  Verbosity verbosity = Verbosity::normal;
};

/// Identifies parameters of a case from what was measured: runs the case with its sensitivities again and again, prints
/// the course and the estimates with their intervals, and writes FOLDER/fit.json and the last accepted run,
/// FOLDER/fitted.h5.
/// @return failed if the search did not converge, with everything written all the same; interrupted after Ctrl-C
/// @throws CaseError, FileError, std::system_error
[[nodiscard]] ExitStatus run_fit(const FitOptions& options);

}  // namespace sundrape

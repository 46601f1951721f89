#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sundrape/app/case_symmetries.hpp"
#include "sundrape/app/end_state.hpp"
#include "sundrape/app/run.hpp"
#include "sundrape/app/shape_distance.hpp"

namespace sundrape {

/// What the command line asks of a crosscheck.
struct CrosscheckOptions {
  std::filesystem::path case_file;
  std::vector<std::string> sets;
  std::optional<std::filesystem::path> folder;  // default: the case's name and "-crosscheck", in the current folder
  int jobs = 0;                                 // processes at a time; 0: one a processor
  Verbosity verbosity = Verbosity::normal;
};

/// Where one method's run of a case ended.
struct MethodEnd {
  std::string name;
  std::filesystem::path result;
  std::string failure;          // empty if the run is done
  std::optional<EndState> end;  // of a run that is done
  std::vector<std::string> warnings;
};

/// An end held against that of the first method.
struct MethodPair {
  std::size_t first = 0, second = 0;  // methods
  ShapeDistance apart;
  EndState laid_on;  // the second's end after the symmetry that brings it closest to the first's
  bool same_branch = false;

  /// On different branches: where the second's end relaxes to.
  struct Relaxed {
    std::filesystem::path result;
    std::string failure;
    std::optional<EndState> end;
    double moved_rms = 0, moved_max = 0;  // [m]
  };
  std::optional<Relaxed> relaxed;
};

/// One case by every method that finds equilibria, and how they agree.
struct Crosscheck {
  std::string title;
  double diagonal = 0, size = 0;  // of the cloth; its longest side [m]
  double same_shape = 0.01;       // RMS over the diagonal below which two ends are on one branch
  std::size_t symmetries = 0;
  std::vector<MethodEnd> methods;
  std::vector<std::string> left_out;  // methods that this version does not have
  std::vector<MethodPair> pairs;
};

/// Runs a case by relaxation, by arc-length and as damped motion until it rests, compares where they end, prints it and
/// writes FOLDER/crosscheck.txt and crosscheck.json; results are FOLDER/<method>.h5.
///
/// Where two ends differ by more than 1 % of the diagonal (RMS, after the case's symmetries) they are on different
/// branches; then the second one is relaxed from where it ended, to see whether it is an equilibrium of statics too.
/// @return failed if a run failed, with the others compared all the same; done also where branches differ
/// @throws CaseError, FileError, std::system_error
[[nodiscard]] ExitStatus run_crosscheck(const CrosscheckOptions& options);

}  // namespace sundrape

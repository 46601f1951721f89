#pragma once
#include <filesystem>
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
  std::vector<std::string> methods;             // names out of crosscheck_method_names(); empty: all
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
  enum class Verdict { same_branch, other_branch, undecided };
  /// Undecided where the second one's end is no equilibrium, or not as stable as the first one's, and far from it.
  Verdict verdict = Verdict::undecided;

  /// Where the second's end relaxes to, if it is not on the first's branch at once.
  struct Relaxed {
    std::filesystem::path result;
    std::string failure;
    std::optional<EndState> end;
    double moved_rms = 0, moved_max = 0;  // from the second's end [m]
    double apart_rms = 0;                 // from the first's end, after the case's symmetries [m]
  };
  std::optional<Relaxed> relaxed;
};

/// One case by every method that finds equilibria, and how they agree.
struct Crosscheck {
  std::string title;
  double diagonal = 0, size = 0;  // of the cloth; its longest side [m]
  double energy_scale = 0;        // weight × L [J]
  double same_drape = 0.01;       // RMS over the diagonal below which two ends look alike
  double same_branch = 1e-3;      // RMS over the longest side below which they are one equilibrium
  std::size_t symmetries = 0;
  std::vector<MethodEnd> methods;
  std::vector<MethodPair> pairs;

  /// Of RMS distances [m].
  [[nodiscard]] bool is_one_branch(double apart) const { return apart < same_branch * size; }
  [[nodiscard]] bool is_one_drape(double apart) const { return apart < same_drape * diagonal; }
};

/// relaxation, arc-length, dynamics.
[[nodiscard]] std::vector<std::string> crosscheck_method_names();

/// Runs a case by relaxation, by arc-length and as damped motion until it rests, compares where they end, prints it and
/// writes FOLDER/crosscheck.txt and crosscheck.json; results are FOLDER/<method>.h5.
///
/// Two ends nearer than 0.1 % of L (RMS, after the case's symmetries) are the same equilibrium. Where they are not, the
/// second one is relaxed from where it ended: that decides between a motion that has all but arrived and another
/// branch, which may be near: a sheet has equilibria that look alike. An end whose forces do not balance to 1 %, or
/// with other negative pivots than the first one's, decides nothing.
/// @return failed if a run failed, with the others compared all the same; done also where branches differ
/// @throws CaseError, FileError, std::system_error
[[nodiscard]] ExitStatus run_crosscheck(const CrosscheckOptions& options);

}  // namespace sundrape

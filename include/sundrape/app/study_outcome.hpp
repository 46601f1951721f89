#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sundrape/app/case_symmetries.hpp"
#include "sundrape/app/drapes.hpp"
#include "sundrape/app/end_state.hpp"
#include "sundrape/app/run_batch.hpp"
#include "sundrape/app/study_table.hpp"
#include "sundrape/io/study.hpp"

namespace sundrape {

/// Runs of a study that can be compared by shape: those with the same values of the study's group axes.
struct StudyGroup {
  std::vector<std::size_t> runs;    // those that are done, ascending
  std::vector<std::size_t> values;  // of the group axes, as indices
  double diagonal = 0;              // of the cloth [m]
  std::size_t symmetries = 0;       // of the case, the identity included
  NeutralMotions neutral;
  std::vector<Drape> drapes;  // members count runs of the study; spreads in m
};

/// Everything that a study has found.
struct StudyOutcome {
  std::vector<std::string> names;         // of runs
  std::vector<BatchOutcome> runs;         // one a combination
  std::optional<BatchOutcome> reference;  // of studies that have one
  StudyTable table;
  std::vector<std::optional<EndState>> ends;  // of runs that are done, in studies that sort drapes
  std::vector<StudyGroup> groups;             // likewise
};

/// A short name for each run, of its axes' values: "seed=3" or "rigidity=1e-6,seed=3"; "run-0007" where that would be
/// too long or not its own.
[[nodiscard]] std::vector<std::string> run_names(const Study& study);

/// Reads the results of finished runs into the table, and sorts each group's end states into drapes.
/// @param jobs  programs at a time; 0: one a processor
/// @throws FileError  a result cannot be read
[[nodiscard]] StudyOutcome study_outcome(const Study& study, std::vector<std::string> names,
                                         std::vector<BatchOutcome> runs, std::optional<BatchOutcome> reference,
                                         int jobs);

}  // namespace sundrape

#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sundrape/app/run_batch.hpp"
#include "sundrape/io/study.hpp"

namespace sundrape {

/// What a study's outputs are of every run: R × O numbers in the outputs' units, NaN where there is none.
struct StudyTable {
  std::vector<std::vector<double>> values;  // [run][output]
  std::vector<std::string> problems;        // why there is none, each once
};

/// Whether an output is about this very computation rather than about the cloth: seconds, which no repetition has
/// again.
[[nodiscard]] bool is_timing(const StudyOutput& output);

/// Holds a study's outputs against a case that it runs.
/// @throws CaseError  an output that the case cannot have, or whose unit is of another dimension; with the study's line
void require_outputs(const Study& study, const Case& c);

/// Gives outputs that are one measure, and for which the study names no unit, the measure's own.
/// @param c  that the outputs have been held against
void complete_units(Study& study, const Case& c);

/// @param runs       one a combination of the axes' values
/// @param reference  if the study has one
/// @param jobs       programs at a time; 0: one a processor
/// @throws FileError  a result cannot be read
[[nodiscard]] StudyTable study_table(const Study& study, const std::vector<BatchOutcome>& runs,
                                     const std::optional<BatchOutcome>& reference, int jobs);

}  // namespace sundrape

#pragma once
#include <map>
#include <string>
#include <vector>

#include "sundrape/app/run_batch.hpp"
#include "sundrape/io/study.hpp"

namespace sundrape {

/// Numbers that a study's programs found in the result of one run, by name.
struct ProgramNumbers {
  std::map<std::string, double> values;
  std::vector<std::string> problems;  // of programs that failed, or whose report lacks a number
};

/// Calls every program of a study on every run that is done, several at a time, and reads their reports.
///
/// "{result}" in a command's words becomes the result's name and "{json}" that of the report, which stays beside it.
/// @param jobs  programs at a time; 0: one a processor
/// @return one a run
/// @throws std::system_error  a log cannot be written
[[nodiscard]] std::vector<ProgramNumbers> run_programs(const Study& study, const std::vector<BatchOutcome>& runs,
                                                       int jobs);

}  // namespace sundrape

#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sundrape/io/case.hpp"

namespace sundrape {

/// A key of the case and the values that a study gives it.
struct StudyAxis {
  std::string key;                  // dotted, as for --set
  std::vector<std::string> values;  // as TOML
  SourceLine source;                // of the values
};

/// A study file, resolved: one case, varied along axes.
struct Study {
  std::string title;
  std::filesystem::path case_file;
  std::vector<std::string> sets;  // of all runs
  std::vector<StudyAxis> axes;
  double same_shape = 0.01;             // RMS node distance over the diagonal below which two end states are one drape
  std::vector<std::size_t> group_axes;  // indices of the axes within whose combinations drapes are formed, ascending
  std::filesystem::path file;

  /// The product of the axes' numbers of values.
  [[nodiscard]] std::size_t runs() const;
  /// Which value of each axis a run has; the last axis varies fastest.
  [[nodiscard]] std::vector<std::size_t> combination(std::size_t run) const;
  /// Of these, those of the axes that make groups: runs that agree in them are of one group.
  [[nodiscard]] std::vector<std::size_t> group_of(std::size_t run) const;
  /// Settings of a run: those of all runs, then one an axis.
  [[nodiscard]] std::vector<std::string> settings(std::size_t run) const;
};

/// Reads a study file; what it asks of the case is not checked here.
/// @throws CaseError          the first thing that is wrong, with the study's line
/// @throws std::system_error  the file cannot be read
[[nodiscard]] Study read_study(const std::filesystem::path& file);

/// Like read_study from text that is at hand already.
[[nodiscard]] Study parse_study(std::string_view text, const std::filesystem::path& file);

}  // namespace sundrape

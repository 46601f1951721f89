#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sundrape/io/case.hpp"
#include "sundrape/io/expression.hpp"

namespace sundrape {

/// One value of an axis: what it sets, and what tables call it.
struct StudyValue {
  std::vector<std::string> settings;  // "key.path=VALUE" with VALUE as TOML, as for --set
  std::string label;
  std::optional<double> number;  // in the axis's unit, for plots; nothing where it is a word or several keys
};

/// What a study varies: a key of the case, or several together.
struct StudyAxis {
  std::string name;               // of tables and figures; of a single key the key itself
  std::vector<std::string> keys;  // all that its values set, dotted
  std::vector<StudyValue> values;
  std::string unit;   // of the values' numbers; empty: a plain number, or SI
  SourceLine source;  // of the values
};

/// A number that a study reads off every run.
struct StudyOutput {
  std::string name;
  Expression expression;
  std::string unit;  // of tables: SI values are divided by `scale`
  double scale = 1;
  SourceLine source;  // of the expression
};

/// Another program that finds numbers in a result.
struct StudyProgram {
  std::vector<std::string> command;                          // words, "{result}" and "{json}" to be filled in
  std::vector<std::pair<std::string, std::string>> numbers;  // name in outputs, and place in the program's JSON report
};

/// A figure that postproc draws from a study's table.
struct StudyFigure {
  std::string name;            // of its file
  std::string x;               // name of an axis or of an output
  std::vector<std::string> y;  // names of outputs
  std::string by;              // the axis that makes a curve of each of its values; empty: one curve
  std::vector<std::string>
      curves;          // labels of the values of `by` that are drawn, in this order; all unless the file says
  std::string panels;  // the axis that makes a panel of each of its values; empty: one panel
  bool log_x = false, log_y = false;
  std::optional<double> slope;  // of a straight line for the eye, in log-log axes
};

/// End states that differ little are one drape.
struct StudyBranches {
  double same_shape = 0.01;             // RMS node distance over the diagonal below which two end states are one drape
  std::vector<std::size_t> group_axes;  // indices of the axes within whose combinations drapes are formed, ascending
};

/// A study file, resolved: one case, varied along axes.
struct Study {
  std::string title;
  std::string text;  // the file's
  std::filesystem::path case_file;
  std::vector<std::string> sets;  // of all runs
  std::vector<StudyAxis> axes;
  std::vector<StudyProgram> programs;
  std::vector<StudyOutput> outputs;
  std::vector<StudyFigure> figures;
  std::optional<std::vector<std::string>> reference;  // settings of one more run, that others are held against
  std::optional<StudyBranches> branches;              // none: end states are not sorted into drapes
  bool resume = false;  // whether runs that were stopped go on from their checkpoints, or begin anew
  std::filesystem::path file;

  /// The product of the axes' numbers of values.
  [[nodiscard]] std::size_t runs() const;
  /// Which value of each axis a run has; the last axis varies fastest.
  [[nodiscard]] std::vector<std::size_t> combination(std::size_t run) const;
  /// Of these, those of the axes that make groups: runs that agree in them are of one group.
  [[nodiscard]] std::vector<std::size_t> group_of(std::size_t run) const;
  /// Settings of a run: those of all runs, then those of its value of each axis.
  [[nodiscard]] std::vector<std::string> settings(std::size_t run) const;
  /// Settings of the reference: those of all runs, then its own.
  [[nodiscard]] std::vector<std::string> reference_settings() const;
  /// Whether a number of outputs is found by a program.
  [[nodiscard]] bool is_programs_number(const std::string& name) const;
  /// What a run has of an axis.
  [[nodiscard]] const StudyValue& value(std::size_t run, std::size_t axis) const {
    return axes[axis].values[combination(run)[axis]];
  }
};

/// Reads a study file; what it asks of the case is not checked here.
/// @throws CaseError          the first thing that is wrong, with the study's line
/// @throws std::system_error  the file cannot be read
[[nodiscard]] Study read_study(const std::filesystem::path& file);

/// Like read_study from text that is at hand already.
[[nodiscard]] Study parse_study(std::string_view text, const std::filesystem::path& file);

}  // namespace sundrape

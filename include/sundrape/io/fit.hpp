#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sundrape/io/case.hpp"

namespace sundrape {

/// A number of the case that is sought.
struct FitParameter {
  ParameterCase parameter;  // the value is where the search begins, the source that of this entry
  double lower = 0, upper = 0;
  bool logarithmic = false;
};

/// Points that lie on a line of nodes, seen in a plane.
struct MeasuredCurve {
  struct Point {
    double first = 0, second = 0, deviation = 0;  // [m]
  };
  std::optional<Selector> nodes;  // none: the boundary of the cloth
  int first_axis = 0, second_axis = 2;
  std::vector<Point> points;
};

/// Where a probe was seen.
struct MeasuredProbe {
  std::string name;
  std::vector<std::pair<int, double>> coordinates;  // axis and value [m]
  double deviation = 0;                             // [m]
};

/// z of the highest node.
struct MeasuredHeight {
  double value = 0, deviation = 0;  // [m]
};

struct Measured {
  std::variant<MeasuredCurve, MeasuredProbe, MeasuredHeight> what;
  std::optional<double> time;  // [s]; none: the end of the run
  SourceLine source;
};

/// A fit file, resolved.
struct Fit {
  std::string title;
  std::filesystem::path file, case_file;
  std::vector<std::string> sets;
  std::vector<FitParameter> parameters;
  std::vector<Measured> measured;
  int max_iterations = 30;
  double tolerance = 1e-2, confidence = 0.95;

  /// How many numbers were measured.
  [[nodiscard]] std::size_t numbers() const;
};

/// Reads a fit file and the tables that it names; its case has to be right too.
/// @throws CaseError          the first thing that is wrong, with its line
/// @throws std::system_error  a file cannot be read
[[nodiscard]] Fit read_fit(const std::filesystem::path& file);

}  // namespace sundrape

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_parameter.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/io/fit.hpp"

#include "case_document.hpp"
#include "case_parts.hpp"
#include "read_text.hpp"

namespace sundrape {
namespace {

/// Numbers of a line of a table; none of a heading.
std::vector<double> numbers_of(std::string line) {
  std::ranges::replace_if(
      line, [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
  std::istringstream text(line);
  std::vector<double> numbers;
  for (double number = 0; text >> number;) numbers.push_back(number);
  return text.eof() ? numbers : std::vector<double>{};
}

std::vector<MeasuredCurve::Point> read_points(const std::filesystem::path& file, double unit, double deviation) {
  std::istringstream text(read_text(file));
  std::vector<MeasuredCurve::Point> points;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    const auto values = numbers_of(line);
    if (values.empty()) continue;
    if (values.size() < 2 || values.size() > 3)
      throw CaseError(file.string(), number, "",
                      fmt::format("two or three numbers are expected, not {}", values.size()));
    const double own = values.size() == 3 ? unit * values[2] : deviation;
    if (!(own > 0)) throw CaseError(file.string(), number, "", fmt::format("a standard deviation of {} m", own));
    points.push_back({unit * values[0], unit * values[1], own});
  }
  return points;
}

MeasuredCurve resolve_curve(const CaseSection& section, const std::filesystem::path& folder) {
  MeasuredCurve curve;
  if (section.text("kind") == "outline") {
    curve.second_axis = 1;
  } else {
    curve.nodes = section.selector("nodes");
    const auto plane = section.text("plane");
    curve.first_axis = plane[0] - 'x';
    curve.second_axis = plane[1] - 'x';
  }
  curve.points = read_points(file_beside(section, "file", folder), section.unit("unit"), section.number("sd"));
  if (curve.points.empty()) section.fail("file", "has no points");
  return curve;
}

MeasuredProbe resolve_probe(const CaseSection& section, const Case& resolved) {
  MeasuredProbe probe{.name = section.text("name"), .coordinates = {}, .deviation = section.number("sd")};
  if (std::ranges::find(resolved.output.probes, probe.name, &ProbeCase::name) == resolved.output.probes.end())
    section.fail("name", fmt::format("the case has no probe '{}'", probe.name));
  for (const auto& [name, axis] : {std::pair("x", 0), std::pair("y", 1), std::pair("z", 2)})
    if (const auto value = section.maybe_number(name)) probe.coordinates.emplace_back(axis, *value);
  if (probe.coordinates.empty()) section.fail("name", "give at least one of x, y, z");
  return probe;
}

/// The time of a frame of the run.
std::optional<double> resolve_time(const CaseSection& section, const Case& resolved) {
  const auto time = section.maybe_number("time");
  if (!time) return time;
  const auto& times = resolved.analysis == Analysis::dynamics ? resolved.output.frame_times : resolved.relaxation.times;
  const double end = times.empty() ? 0 : times.back();
  if (std::ranges::none_of(times, [&](double t) { return std::abs(t - *time) <= 1e-9 * end; }))
    section.fail("time",
                 fmt::format("the run has no frame at {:.10g} s: see output.every, or relaxation.times", *time));
  return time;
}

Measured resolve_measured(const CaseSection& section, const Case& resolved, const std::filesystem::path& folder) {
  const auto kind = section.text("kind");
  Measured m{.what = {}, .time = resolve_time(section, resolved), .source = section.source()};
  if (kind == "probe")
    m.what = resolve_probe(section, resolved);
  else if (kind == "height")
    m.what = MeasuredHeight{section.number("value"), section.number("sd")};
  else
    m.what = resolve_curve(section, folder);
  return m;
}

FitParameter resolve_parameter(const CaseSection& section, const Case& resolved) {
  FitParameter p{find_parameter(resolved, section.text("key"), section.source("key"))};
  const auto& range = p.parameter.range;
  const auto quantity = [&](const char* name, double otherwise) {
    return section.maybe_quantity(name, p.parameter.unit).value_or(otherwise);
  };
  p.parameter.value = quantity("start", p.parameter.value);
  p.lower = quantity("lower", range.low);
  p.upper = quantity("upper", range.high);
  if (!(p.lower < p.parameter.value && p.parameter.value < p.upper))
    section.fail("start", fmt::format("{:.10g} is not between {:.10g} and {:.10g} {}", p.parameter.value, p.lower,
                                      p.upper, p.parameter.unit));
  for (const auto& [name, bound] : {std::pair("lower", p.lower), std::pair("upper", p.upper)})
    if (section.has(name) && !range.contains(bound))
      section.fail(name, fmt::format("{:.10g} is outside {} {}", bound, range.text(), p.parameter.unit));
  const auto scale = section.text("scale");
  p.logarithmic = scale == "log" || (scale == "auto" && p.lower >= 0);
  if (p.logarithmic && !(p.lower >= 0)) section.fail("scale", "a logarithm needs a lower bound of 0 or more");
  return p;
}

}  // namespace

std::size_t Fit::numbers() const {
  std::size_t sum = 0;
  for (const auto& m : measured) {
    if (const auto* curve = std::get_if<MeasuredCurve>(&m.what)) sum += curve->points.size();
    if (const auto* probe = std::get_if<MeasuredProbe>(&m.what)) sum += probe->coordinates.size();
    if (std::holds_alternative<MeasuredHeight>(m.what)) ++sum;
  }
  return sum;
}

Fit read_fit(const std::filesystem::path& file) {
  const toml::table root = parse_toml(read_text(file), file.string());
  const ReadingContext context(fit_key_table());
  const CaseSection top(context, key_section("", fit_key_table()), &root, {file.string(), 1, ""});
  top.check();
  const auto folder = file.parent_path();
  Fit fit;
  fit.file = file;
  fit.title = top.has("title") ? top.text("title") : file.stem().string();
  fit.case_file = folder / top.text("case");
  if (!std::filesystem::is_regular_file(fit.case_file))
    top.fail("case", fmt::format("'{}' is not there (sought beside the fit file)", top.text("case")));
  fit.sets = top.texts("set");
  fit.max_iterations = top.integer("max_iterations");
  fit.tolerance = top.number("tolerance");
  fit.confidence = top.number("confidence");
  const Case resolved = read_case(fit.case_file, fit.sets);
  for (const auto& section : top.tables("parameter")) {
    auto p = resolve_parameter(section, resolved);
    for (const auto& earlier : fit.parameters)
      if (earlier.parameter.key == p.parameter.key)
        section.fail("key", fmt::format("'{}' stands there twice", p.parameter.key));
    fit.parameters.push_back(std::move(p));
  }
  for (const auto& section : top.tables("measured"))
    fit.measured.push_back(resolve_measured(section, resolved, folder));
  if (fit.parameters.empty()) top.fail("parameter", "a fit needs a parameter: write [[parameter]]");
  if (fit.numbers() < fit.parameters.size())
    top.fail("measured",
             fmt::format("{} measured numbers cannot tell {} parameters", fit.numbers(), fit.parameters.size()));
  return fit;
}

}  // namespace sundrape

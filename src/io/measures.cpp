#include "sundrape/io/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "sundrape/io/compare.hpp"

namespace sundrape {
namespace {

[[noreturn]] void missing(const ResultReader& result, const std::string& name) {
  throw std::invalid_argument(fmt::format("{}: holds no '{}'", result.file().name(), name));
}

/// The entry whose name reads as `word` in expressions.
template <class Entry>
const Entry* find_word(const std::map<std::string, Entry>& all, const std::string& word) {
  for (const auto& [name, entry] : all)
    if (as_word(name) == word) return &entry;
  return nullptr;
}

Eigen::Index component(char axis) { return axis - 'x'; }

MeasureSeries probe_series(const ResultReader& result, const std::string& name) {
  const auto dot = name.rfind('.');
  const auto probe = name.substr(6, dot - 6), what = name.substr(dot + 1);
  const auto all = result.probes();
  const auto* found = find_word(all, probe);
  if (found == nullptr) missing(result, name);
  const auto& history = *found;
  const auto k = component(what.back());
  const bool of_rates = what.starts_with('v');
  MeasureSeries series{.variable = history.time};
  for (const auto& x : of_rates ? history.velocity : history.position) series.value.push_back(x[k]);
  if (!of_rates && result.frame_variable() == FrameVariable::time && result.analysis() == "dynamics")
    for (const auto& v : history.velocity) series.rate.push_back(v[k]);
  return series;
}

std::vector<double> energy(const ResultReader& result, const std::string& kind) {
  const auto all = result.energies();
  if (kind != "total") {
    const auto found = all.find(kind);
    if (found == all.end()) missing(result, "energy." + kind);
    return found->second;
  }
  std::vector<double> sum(result.frames(), 0.0);
  for (const auto* part : {"kinetic", "membrane", "shear", "bending", "gravity", "contact"})
    for (std::size_t f = 0; f < sum.size(); ++f) sum[f] += all.at(part)[f];
  return sum;
}

std::vector<double> components(const std::vector<Vector3>& vectors, char axis) {
  std::vector<double> values;
  values.reserve(vectors.size());
  for (const auto& v : vectors) values.push_back(v[component(axis)]);
  return values;
}

std::vector<double> extreme_height(const ResultReader& result, bool top) {
  std::vector<double> values;
  for (std::size_t f = 0; f < result.frames(); ++f) {
    const Vector position = result.position(f);
    const auto z = position.reshaped(3, position.size() / 3).row(2);
    values.push_back(top ? z.maxCoeff() : z.minCoeff());
  }
  return values;
}

std::vector<double> frame_values(const ResultReader& result, const std::string& name) {
  if (name.starts_with("energy.")) return energy(result, name.substr(7));
  if (name.starts_with("reaction.")) {
    const auto all = result.reactions();
    const auto* found = find_word(all, name.substr(9, name.rfind('.') - 9));
    if (found == nullptr) missing(result, name);
    return components(*found, name.back());
  }
  if (name.starts_with("contact.force.")) return components(result.contact_force_sum(), name.back());
  if (name == "contact.penetration") return result.penetration();
  if (name == "shape.top" || name == "shape.bottom") return extreme_height(result, name == "shape.top");
  if (name == "frame.residual") return result.residual();
  missing(result, name);
}

MeasureSeries step_series(const ResultReader& result, const std::string& name) {
  auto columns = result.step_columns();
  const auto found = columns.find(name.substr(5));
  if (found == columns.end()) missing(result, name);
  const auto counter = columns.find("time") != columns.end() ? "time" : "load_factor";
  return {.variable = columns.at(counter), .value = found->second};
}

MeasureSeries distance_series(const ResultReader& result, const ResultReader& reference, bool largest) {
  const auto comparison = compare(result, reference);
  MeasureSeries series{.variable = comparison.series.variable};
  for (const auto& d : comparison.series.distance) series.value.push_back(largest ? d.max : d.rms);
  if (series.value.empty()) {  // static ends, whose frames cannot be paired
    series.variable = {comparison.last_a};
    series.value = {largest ? comparison.last.max : comparison.last.rms};
  }
  return series;
}

/// Cubic Hermite interpolation over [0, h].
double hermite(double y0, double y1, double r0, double r1, double h, double t) {
  const double s = t / h, c = 1 - s;
  return c * c * ((1 + 2 * s) * y0 + t * r0) + s * s * ((3 - 2 * s) * y1 - (h - t) * r1);
}

/// Where the variable first comes to `at`; load factors may turn back.
double value_at(const MeasureSeries& series, double at) {
  const auto& x = series.variable;
  const auto [low, high] = std::ranges::minmax(x);
  const double slack = 1e-9 * std::max(std::abs(low), std::abs(high));
  if (!(at >= low - slack && at <= high + slack))
    throw std::invalid_argument(fmt::format("{:g} is outside of [{:g}, {:g}]", at, low, high));
  const double place = std::clamp(at, low, high);
  std::size_t k = 0;
  while (x[k] != place && (k == 0 || (x[k] - place) * (x[k - 1] - place) > 0)) ++k;
  if (x[k] == place) return series.value[k];
  const double h = x[k] - x[k - 1], t = place - x[k - 1];
  if (series.rate.empty()) return series.value[k - 1] + t / h * (series.value[k] - series.value[k - 1]);
  return hermite(series.value[k - 1], series.value[k], series.rate[k - 1], series.rate[k], h, t);
}

double mean(const MeasureSeries& series) {
  double area = 0;
  for (std::size_t k = 1; k < series.value.size(); ++k)
    area += 0.5 * (series.value[k] + series.value[k - 1]) * (series.variable[k] - series.variable[k - 1]);
  const double span = series.variable.back() - series.variable.front();
  return span > 0 ? area / span : series.value.front();
}

}  // namespace

double reduce(const MeasureSeries& series, const Reduction& reduction) {
  if (series.value.empty()) throw std::invalid_argument(fmt::format("'{}' has no entries", reduction.series));
  const auto low = std::ranges::min_element(series.value), high = std::ranges::max_element(series.value);  // the first
  const auto variable_of = [&](auto entry) {
    return series.variable[static_cast<std::size_t>(entry - series.value.begin())];
  };
  const auto& f = reduction.function;
  if (f == "first") return series.value.front();
  if (f == "last") return series.value.back();
  if (f == "min") return *low;
  if (f == "max") return *high;
  if (f == "range") return *high - *low;
  if (f == "argmin") return variable_of(low);
  if (f == "argmax") return variable_of(high);
  if (f == "mean") return mean(series);
  return value_at(series, reduction.at);
}

Measures::Measures(const ResultReader& result, const ResultReader* reference)
    : result_(result), reference_(reference) {}

double Measures::number(const std::string& name) const {
  if (name == "nodes") return result_.mesh().nodes();
  if (name == "diagonal") return diagonal(result_.mesh());
  for (const auto& statistic : result_.statistics()) {
    if (statistic.name != name) continue;
    if (const auto* whole = std::get_if<std::int64_t>(&statistic.value)) return static_cast<double>(*whole);
    if (const auto* real = std::get_if<double>(&statistic.value)) return *real;
  }
  missing(result_, name);
}

MeasureSeries Measures::series(const std::string& name) const {
  if (name.starts_with("probe.")) return probe_series(result_, name);
  if (name.starts_with("step.")) return step_series(result_, name);
  if (name.starts_with("reference.")) {
    if (reference_ == nullptr) missing(result_, name);
    return distance_series(result_, *reference_, name == "reference.max");
  }
  return {.variable = result_.frame_values(), .value = frame_values(result_, name)};
}

}  // namespace sundrape

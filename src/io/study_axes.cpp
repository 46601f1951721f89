#include "study_axes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace sundrape {
namespace {

std::vector<double> range_numbers(const CaseSection& range) {
  const double from = range.number("from"), to = range.number("to");
  if (range.has("step") && range.has("count")) range.fail("step", "count says it already: give either, not both");
  const bool log = range.text("spacing") == "log";
  std::vector<double> numbers;
  if (range.has("count")) {
    if (log && !(from > 0 && to > 0)) range.fail("spacing", "log needs `from` and `to` above 0");
    const int count = range.integer("count");
    for (int i = 0; i < count; ++i) {
      const double part = static_cast<double>(i) / (count - 1);
      numbers.push_back(i + 1 == count ? to : log ? from * std::pow(to / from, part) : from + part * (to - from));
    }
    return numbers;
  }
  if (log) range.fail("spacing", "log needs `count`");
  const double step = range.maybe_number("step").value_or(1);
  if (!(to >= from)) range.fail("to", fmt::format("{:.10g} is below `from`, {:.10g}", to, from));
  const double steps = std::floor((to - from) / step * (1 + 1e-12) + 1e-9);
  if (!(steps < static_cast<double>(most_study_runs)))
    range.fail("step", fmt::format("makes {:.10g} values, more than {}", steps + 1, most_study_runs));
  for (int i = 0; i <= static_cast<int>(steps); ++i) numbers.push_back(from + i * step);
  return numbers;
}

std::vector<std::string> range_values(const CaseSection& range) {
  std::vector<std::string> values;
  for (const double number : range_numbers(range)) {
    // Whole numbers as such, since that is what some keys insist on.
    const bool whole = number == std::round(number) && std::abs(number) < 1e15;
    const auto text = whole ? fmt::format("{:.0f}", number) : fmt::format("{:.12g}", number);
    values.push_back(range.has("unit") ? fmt::format("\"{} {}\"", text, range.text("unit")) : text);
  }
  return values;
}

/// What a value is called: a string without its quotes.
std::string label_of(const std::string& toml) {
  const bool quoted = toml.size() >= 2 && toml.front() == '"' && toml.back() == '"';
  return quoted ? toml.substr(1, toml.size() - 2) : toml;
}

/// "0.5 mm" as 0.5 and "mm"; nothing if it does not begin with a number.
std::optional<std::pair<double, std::string>> number_and_unit(const std::string& label) {
  double number = 0;
  const auto [end, problem] = std::from_chars(label.data(), label.data() + label.size(), number);
  if (problem != std::errc() || !std::isfinite(number)) return std::nullopt;
  auto unit = label.substr(static_cast<std::size_t>(end - label.data()));
  unit.erase(0, unit.find_first_not_of(' '));
  return std::pair(number, unit);
}

/// Numbers of all values, if all are numbers of one unit.
void find_numbers(StudyAxis& axis) {
  std::set<std::string> units;
  std::vector<double> numbers;
  for (const auto& value : axis.values)
    if (const auto found = number_and_unit(value.label)) {
      numbers.push_back(found->first);
      units.insert(found->second);
    }
  if (numbers.size() != axis.values.size() || units.size() != 1) return;
  axis.unit = *units.begin();
  for (std::size_t k = 0; k < numbers.size(); ++k) axis.values[k].number = numbers[k];
}

void read_values(const CaseSection& section, StudyAxis& axis) {
  axis.source = section.source("values");
  const auto key = section.text("key");
  if (key.empty()) section.fail("key", "the key is empty");
  axis.keys = {key};
  const auto listed = section.listed_values("values");
  for (const auto& text : listed ? *listed : range_values(section.table("values")))
    axis.values.push_back({.settings = {fmt::format("{}={}", key, text)}, .label = label_of(text), .number = {}});
}

void read_settings(const CaseSection& section, StudyAxis& axis) {
  axis.source = section.source("settings");
  for (const auto& settings : section.text_lists("settings")) {
    for (const auto& setting : settings) {
      const auto equals = setting.find('=');
      if (equals == 0 || equals == std::string::npos)
        section.fail("settings", fmt::format("'{}' is no setting: write \"key.path=value\"", setting));
      if (const auto key = setting.substr(0, equals); std::ranges::find(axis.keys, key) == axis.keys.end())
        axis.keys.push_back(key);
    }
    axis.values.push_back({.settings = settings, .label = fmt::format("{}", axis.values.size() + 1), .number = {}});
  }
  if (axis.values.empty()) section.fail("settings", "the list is empty");
  if (!section.has("name")) section.fail("name", "missing: an axis of `settings` needs a name");
}

void read_labels(const CaseSection& section, StudyAxis& axis) {
  if (!section.has("labels")) return;
  const auto labels = section.texts("labels");
  if (labels.size() != axis.values.size())
    section.fail("labels", fmt::format("{} labels of {} values", labels.size(), axis.values.size()));
  for (std::size_t k = 0; k < labels.size(); ++k) axis.values[k].label = labels[k];
}

void require_different(const CaseSection& section, const StudyAxis& axis) {
  std::set<std::string> labels;
  const auto* key = section.has("labels") ? "labels" : section.has("values") ? "values" : "settings";
  for (const auto& value : axis.values)
    if (!labels.insert(value.label).second) section.fail(key, fmt::format("{} stands there twice", value.label));
}

}  // namespace

StudyAxis read_axis(const CaseSection& section) {
  StudyAxis axis;
  const bool by_key = section.has("key") || section.has("values");
  if (by_key == section.has("settings"))
    section.fail(by_key ? "settings" : "key", by_key ? "an axis has either `key` and `values` or `settings`, not both"
                                                     : "missing: `key` with `values`, or `settings`");
  by_key ? read_values(section, axis) : read_settings(section, axis);
  axis.name = section.has("name") ? section.text("name") : axis.keys.front();
  read_labels(section, axis);
  find_numbers(axis);
  require_different(section, axis);
  return axis;
}

}  // namespace sundrape

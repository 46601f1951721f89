#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/nearest_name.hpp"
#include "sundrape/io/study.hpp"

#include "case_document.hpp"
#include "case_section.hpp"
#include "read_text.hpp"

namespace sundrape {
namespace {

constexpr std::size_t most_values = 100000;  // of an axis and of a whole study: more is a slip

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
  if (!(steps < static_cast<double>(most_values)))
    range.fail("step", fmt::format("makes {:.10g} values, more than {}", steps + 1, most_values));
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

StudyAxis resolve_axis(const CaseSection& section) {
  StudyAxis axis{.key = section.text("key"), .values = {}, .source = section.source("values")};
  if (axis.key.empty()) section.fail("key", "the key is empty");
  const auto listed = section.listed_values("values");
  axis.values = listed ? *listed : range_values(section.table("values"));
  for (auto value = axis.values.begin(); value != axis.values.end(); ++value)
    if (std::find(axis.values.begin(), value, *value) != value)
      section.fail("values", fmt::format("{} stands there twice", *value));
  return axis;
}

/// Whether a key says how an equilibrium is looked for, rather than what it is an equilibrium of.
bool is_a_way_there(std::string_view key) {
  constexpr std::array ways{"cloth.waviness", "cloth.start", "analysis", "relaxation",
                            "arc-length",     "dynamics",    "output"};
  return std::ranges::any_of(ways, [&](std::string_view way) {
    return key == way || (key.starts_with(way) && key.size() > way.size() && key[way.size()] == '.');
  });
}

std::vector<std::size_t> group_axes(const CaseSection& branches, const std::vector<StudyAxis>& axes) {
  std::vector<std::size_t> chosen;
  if (!branches.has("group_by")) {
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (!is_a_way_there(axes[a].key)) chosen.push_back(a);
    return chosen;
  }
  std::vector<std::string> keys;
  keys.reserve(axes.size());
  for (const auto& axis : axes) keys.push_back(axis.key);
  for (const auto& key : branches.texts("group_by")) {
    const auto found = std::ranges::find(keys, key);
    if (found == keys.end()) {
      const auto near = nearest_name(key, keys);
      branches.fail("group_by",
                    fmt::format("'{}' is the key of no axis{}; accepted: {}", key,
                                near.empty() ? "" : fmt::format(", did you mean '{}'?", near), fmt::join(keys, ", ")));
    }
    chosen.push_back(static_cast<std::size_t>(found - keys.begin()));
  }
  std::ranges::sort(chosen);
  if (std::ranges::adjacent_find(chosen) != chosen.end()) branches.fail("group_by", "a key stands there twice");
  return chosen;
}

}  // namespace

std::size_t Study::runs() const {
  std::size_t product = 1;
  for (const auto& axis : axes) product *= axis.values.size();
  return product;
}

std::vector<std::size_t> Study::combination(std::size_t run) const {
  std::vector<std::size_t> chosen(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    chosen[a] = run % axes[a].values.size();
    run /= axes[a].values.size();
  }
  return chosen;
}

std::vector<std::size_t> Study::group_of(std::size_t run) const {
  const auto chosen = combination(run);
  std::vector<std::size_t> values;
  values.reserve(group_axes.size());
  for (const auto axis : group_axes) values.push_back(chosen[axis]);
  return values;
}

std::vector<std::string> Study::settings(std::size_t run) const {
  auto all = sets;
  const auto chosen = combination(run);
  for (std::size_t a = 0; a < axes.size(); ++a) all.push_back(axes[a].key + "=" + axes[a].values[chosen[a]]);
  return all;
}

Study parse_study(std::string_view text, const std::filesystem::path& file) {
  const toml::table root = parse_toml(text, file.string());
  const ReadingContext context(study_key_table());
  const CaseSection top(context, key_section("", study_key_table()), &root, {file.string(), 1, ""});
  top.check();

  Study study;
  study.file = file;
  study.title = top.has("title") ? top.text("title") : file.stem().string();
  study.case_file = file.parent_path() / top.text("case");
  if (!std::filesystem::is_regular_file(study.case_file))
    top.fail("case", fmt::format("'{}' is not there (sought beside the study file)", top.text("case")));
  study.sets = top.texts("set");
  std::size_t runs = 1;
  for (const auto& section : top.tables("axis")) {
    auto axis = resolve_axis(section);
    for (const auto& earlier : study.axes)
      if (earlier.key == axis.key) section.fail("key", fmt::format("'{}' is the key of two axes", axis.key));
    runs *= axis.values.size();
    if (runs > most_values) section.fail("values", fmt::format("the study has more than {} runs", most_values));
    study.axes.push_back(std::move(axis));
  }
  if (study.axes.empty()) top.fail("axis", "a study needs an axis: write [[axis]]");
  const CaseSection branches = top.table("branches");
  study.same_shape = branches.number("same_shape");
  study.group_axes = group_axes(branches, study.axes);
  return study;
}

Study read_study(const std::filesystem::path& file) { return parse_study(read_text(file), file); }

}  // namespace sundrape

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/nearest_name.hpp"
#include "sundrape/io/study.hpp"

#include "case_document.hpp"
#include "case_section.hpp"
#include "read_text.hpp"
#include "study_axes.hpp"

namespace sundrape {
namespace {

/// Whether a key says how an equilibrium is looked for, rather than what it is an equilibrium of.
bool is_a_way_there(std::string_view key) {
  constexpr std::array ways{"cloth.waviness", "cloth.start", "analysis", "relaxation",
                            "arc-length",     "dynamics",    "output"};
  return std::ranges::any_of(ways, [&](std::string_view way) {
    return key == way || (key.starts_with(way) && key.size() > way.size() && key[way.size()] == '.');
  });
}

bool is_a_way_there(const StudyAxis& axis) {
  return std::ranges::all_of(axis.keys, [](const auto& key) { return is_a_way_there(std::string_view(key)); });
}

/// "'x' is <what>, did you mean 'y'?; accepted: ..."
std::string not_among(const std::string& written, const char* what, const std::vector<std::string>& names) {
  const auto near = nearest_name(written, names);
  return fmt::format("'{}' is {}{}; accepted: {}", written, what,
                     near.empty() ? "" : fmt::format(", did you mean '{}'?", near), fmt::join(names, ", "));
}

std::vector<std::string> axis_names(const Study& study) {
  std::vector<std::string> names;
  names.reserve(study.axes.size());
  for (const auto& axis : study.axes) names.push_back(axis.name);
  return names;
}

std::vector<std::size_t> group_axes(const CaseSection& branches, const Study& study) {
  std::vector<std::size_t> chosen;
  if (!branches.has("group_by")) {
    for (std::size_t a = 0; a < study.axes.size(); ++a)
      if (!is_a_way_there(study.axes[a])) chosen.push_back(a);
    return chosen;
  }
  const auto names = axis_names(study);
  for (const auto& name : branches.texts("group_by")) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) branches.fail("group_by", not_among(name, "the name of no axis", names));
    chosen.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  std::ranges::sort(chosen);
  if (std::ranges::adjacent_find(chosen) != chosen.end()) branches.fail("group_by", "an axis stands there twice");
  return chosen;
}

void read_axes(const CaseSection& top, Study& study) {
  std::size_t runs = 1;
  for (const auto& section : top.tables("axis")) {
    auto axis = read_axis(section);
    for (const auto& earlier : study.axes) {
      if (earlier.name == axis.name)
        section.fail(section.has("name") ? "name" : "key", fmt::format("'{}' is the name of two axes", axis.name));
      for (const auto& key : axis.keys)
        if (std::ranges::find(earlier.keys, key) != earlier.keys.end())
          section.fail(section.has("key") ? "key" : "settings", fmt::format("'{}' is the key of two axes", key));
    }
    runs *= axis.values.size();
    if (runs > most_study_runs)
      throw CaseError(axis.source, fmt::format("the study has more than {} runs", most_study_runs));
    study.axes.push_back(std::move(axis));
  }
  if (study.axes.empty()) top.fail("axis", "a study needs an axis: write [[axis]]");
}

StudyOutput read_output(const CaseSection& section, const Units& units) {
  try {
    StudyOutput output{.name = section.text("name"),
                       .expression = Expression(section.text("value"), units),
                       .unit = section.has("unit") ? section.text("unit") : "",
                       .source = section.source("value")};
    if (output.unit.empty()) return output;
    try {
      output.scale = units.in_si(output.unit);
    } catch (const std::invalid_argument& problem) {
      section.fail("unit", problem.what());
    }
    return output;
  } catch (const std::invalid_argument& problem) {
    section.fail("value", problem.what());
  }
}

void read_outputs(const CaseSection& top, const Units& units, Study& study) {
  std::set<std::string> taken{"run", "status", "drape"};
  for (const auto& axis : study.axes) taken.insert(axis.name);
  for (const auto& section : top.tables("output")) {
    study.outputs.push_back(read_output(section, units));
    if (const auto& name = study.outputs.back().name; !taken.insert(name).second)
      section.fail("name", fmt::format("'{}' is the name of another column of the table", name));
  }
}

/// "name=/place/in/the/report"
std::pair<std::string, std::string> read_program_number(const CaseSection& section, const std::string& text) {
  const auto equals = text.find('=');
  const auto name = text.substr(0, equals);
  const bool is_word = !name.empty() && name.find_first_of(".- +*/^()") == std::string::npos;
  if (equals == std::string::npos || !is_word || text.size() < equals + 2 || text[equals + 1] != '/')
    section.fail("numbers", fmt::format("'{}' is no number of a report: write \"name=/place/in/it\"", text));
  return {name, text.substr(equals + 1)};
}

StudyProgram read_program(const CaseSection& section) {
  StudyProgram program{.command = section.texts("command"), .numbers = {}};
  if (program.command.empty()) section.fail("command", "the list is empty");
  if (std::ranges::none_of(program.command, [](const auto& word) { return word.find("{json}") != std::string::npos; }))
    section.fail("command", "no word has {json}, the name of the report that the program is to write");
  for (const auto& text : section.texts("numbers")) program.numbers.push_back(read_program_number(section, text));
  return program;
}

/// Labels of the values of a figure's `by` that it draws, in its order.
std::vector<std::string> read_curves(const CaseSection& section, const std::string& by, const Study& study) {
  if (by.empty()) {
    if (section.has("curves")) section.fail("curves", "they are values of an axis: say which with `by`");
    return {};
  }
  const auto axis = std::ranges::find(study.axes, by, &StudyAxis::name);
  std::vector<std::string> labels;
  labels.reserve(axis->values.size());
  for (const auto& value : axis->values) labels.push_back(value.label);
  if (!section.has("curves")) return labels;
  auto curves = section.texts("curves");
  if (curves.empty()) section.fail("curves", "the list is empty");
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (std::ranges::find(labels, curves[k]) == labels.end())
      section.fail("curves", not_among(curves[k], fmt::format("no value of '{}'", by).c_str(), labels));
    if (std::ranges::find(curves, curves[k]) != curves.begin() + static_cast<std::ptrdiff_t>(k))
      section.fail("curves", fmt::format("{} stands there twice", curves[k]));
  }
  return curves;
}

StudyFigure read_figure(const CaseSection& section, const Study& study) {
  const auto axes = axis_names(study);
  std::vector<std::string> outputs;
  outputs.reserve(study.outputs.size());
  for (const auto& output : study.outputs) outputs.push_back(output.name);
  auto columns = axes;
  columns.insert(columns.end(), outputs.begin(), outputs.end());
  const auto among = [&](const char* key, const std::string& name, const std::vector<std::string>& names,
                         const char* what) {
    if (std::ranges::find(names, name) == names.end()) section.fail(key, not_among(name, what, names));
    return name;
  };
  const auto maybe_axis = [&](const char* key) {
    return section.has(key) ? among(key, section.text(key), axes, "the name of no axis") : std::string();
  };
  StudyFigure figure{.name = section.text("name"),
                     .x = among("x", section.text("x"), columns, "the name of no axis and of no output"),
                     .y = section.texts("y"),
                     .by = maybe_axis("by"),
                     .curves = {},
                     .panels = maybe_axis("panels"),
                     .log_x = section.boolean("log_x"),
                     .log_y = section.boolean("log_y"),
                     .slope = section.maybe_number("slope")};
  if (figure.y.empty()) section.fail("y", "the list is empty");
  figure.curves = read_curves(section, figure.by, study);
  for (const auto& name : figure.y) (void)among("y", name, outputs, "the name of no output");
  return figure;
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
  if (branches)
    for (const auto axis : branches->group_axes) values.push_back(chosen[axis]);
  return values;
}

std::vector<std::string> Study::settings(std::size_t run) const {
  auto all = sets;
  const auto chosen = combination(run);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto& settings = axes[a].values[chosen[a]].settings;
    all.insert(all.end(), settings.begin(), settings.end());
  }
  return all;
}

std::vector<std::string> Study::reference_settings() const {
  auto all = sets;
  all.insert(all.end(), reference->begin(), reference->end());
  return all;
}

bool Study::is_programs_number(const std::string& name) const {
  return std::ranges::any_of(programs, [&](const auto& program) {
    return std::ranges::any_of(program.numbers, [&](const auto& number) { return number.first == name; });
  });
}

Study parse_study(std::string_view text, const std::filesystem::path& file) {
  const toml::table root = parse_toml(text, file.string());
  const ReadingContext context(study_key_table());
  const CaseSection top(context, key_section("", study_key_table()), &root, {file.string(), 1, ""});
  top.check();

  Study study;
  study.file = file;
  study.text = text;
  study.title = top.has("title") ? top.text("title") : file.stem().string();
  study.case_file = file.parent_path() / top.text("case");
  if (!std::filesystem::is_regular_file(study.case_file))
    top.fail("case", fmt::format("'{}' is not there (sought beside the study file)", top.text("case")));
  study.sets = top.texts("set");
  study.resume = top.boolean("resume");
  read_axes(top, study);
  for (const auto& section : top.tables("program")) study.programs.push_back(read_program(section));
  read_outputs(top, context.units(), study);
  for (const auto& section : top.tables("figure")) study.figures.push_back(read_figure(section, study));
  if (top.has("reference")) study.reference = top.table("reference").texts("set");
  if (top.has("branches") || study.outputs.empty()) {
    const CaseSection branches = top.table("branches");
    study.branches = {.same_shape = branches.number("same_shape"), .group_axes = group_axes(branches, study)};
  }
  return study;
}

Study read_study(const std::filesystem::path& file) { return parse_study(read_text(file), file); }

}  // namespace sundrape

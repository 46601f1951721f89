#include "sundrape/app/study_table.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "sundrape/app/study_programs.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/measures.hpp"

namespace sundrape {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The SI unit of an output that is one measure and nothing else; empty where that is not known.
std::string si_unit(const Study& study, const StudyOutput& output, const Case& c) {
  const auto* reduction = output.expression.single_reduction();
  const auto* number = output.expression.single_number();
  if (reduction == nullptr && (number == nullptr || study.is_programs_number(*number))) return {};
  if (reduction != nullptr && reduction->function.starts_with("arg"))
    return c.analysis == Analysis::arc_length ? "1" : "s";
  return measure_info(reduction != nullptr ? reduction->series : *number, c, study.reference.has_value()).unit;
}

std::vector<double> row(const Study& study, const BatchOutcome& run, const ResultReader* reference,
                        const ProgramNumbers& of_programs, std::vector<std::string>& problems) {
  std::vector<double> values(study.outputs.size(), no_number);
  if (run.status != BatchStatus::done) return values;
  const ResultReader result(run.result);
  const Measures measures(result, reference);
  const auto number = [&](const std::string& name) {
    if (!study.is_programs_number(name)) return measures.number(name);
    const auto found = of_programs.values.find(name);
    return found == of_programs.values.end() ? no_number : found->second;
  };
  problems.insert(problems.end(), of_programs.problems.begin(), of_programs.problems.end());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto& output = study.outputs[k];
    try {
      values[k] =
          output.expression.evaluate([&](const Reduction& r) { return reduce(measures.series(r.series), r); }, number) /
          output.scale;
    } catch (const std::invalid_argument& problem) {
      problems.push_back(fmt::format("{}: {}", output.name, problem.what()));
    }
  }
  return values;
}

}  // namespace

bool is_timing(const StudyOutput& output) {
  const auto& known = number_catalogue();
  return std::ranges::any_of(output.expression.numbers(), [&](const auto& name) {
    return std::ranges::any_of(known, [&](const auto& info) { return info.name == name && info.timing; });
  });
}

void require_outputs(const Study& study, const Case& c) {
  if (study.outputs.empty()) return;
  const Units units;
  const bool with_reference = study.reference.has_value();
  for (const auto& output : study.outputs) {
    try {
      for (const auto& reduction : output.expression.reductions())
        (void)measure_info(reduction.series, c, with_reference);
      for (const auto& number : output.expression.numbers())
        if (!study.is_programs_number(number)) (void)measure_info(number, c, with_reference);
      const auto unit = si_unit(study, output, c);
      if (!output.unit.empty() && !unit.empty()) (void)units.parse_quantity("1 " + output.unit, unit);
    } catch (const std::invalid_argument& problem) {
      throw CaseError(output.source, problem.what());
    }
  }
}

void complete_units(Study& study, const Case& c) {
  for (auto& output : study.outputs) {
    if (!output.unit.empty()) continue;
    const auto unit = si_unit(study, output, c);
    if (unit != "1") output.unit = unit;
  }
}

StudyTable study_table(const Study& study, const std::vector<BatchOutcome>& runs,
                       const std::optional<BatchOutcome>& reference, int jobs) {
  StudyTable table;
  std::optional<ResultReader> held_against;
  if (reference && reference->status == BatchStatus::done) held_against.emplace(reference->result);
  table.values.reserve(runs.size());
  const auto of_programs = run_programs(study, runs, jobs);
  for (std::size_t k = 0; k < runs.size(); ++k)
    table.values.push_back(
        row(study, runs[k], held_against ? &*held_against : nullptr, of_programs[k], table.problems));
  std::ranges::sort(table.problems);
  table.problems.erase(std::unique(table.problems.begin(), table.problems.end()), table.problems.end());
  return table;
}

}  // namespace sundrape

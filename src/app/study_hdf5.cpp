#include <algorithm>
#include <filesystem>

#include "sundrape/app/study_report.hpp"
#include "sundrape/io/hdf5.hpp"
#include "sundrape/version.hpp"

#include "study_labels.hpp"

namespace sundrape {
namespace {

namespace fs = std::filesystem;
using hdf5::Element;

void write_texts(hdf5::File& file, const std::string& path, const std::vector<std::string>& texts,
                 const std::string& description) {
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  std::string bytes;
  for (auto text : texts) {
    text.resize(length);
    bytes += text;
  }
  file.create_dataset(path, {.element = Element::text, .shape = {texts.size()}, .text_length = length})
      .write_rows(0, texts.size(), std::as_bytes(std::span(bytes)));
  file.set_attribute(path, "description", description);
}

template <class T>
void write_numbers(hdf5::File& file, const std::string& path, Element element, const std::vector<std::uint64_t>& shape,
                   const std::vector<T>& numbers, const std::string& units, const std::string& description) {
  file.create_dataset(path, {.element = element, .shape = shape})
      .write_rows(0, shape.front(), std::as_bytes(std::span(numbers)));
  file.set_attribute(path, "units", units);
  file.set_attribute(path, "description", description);
}

void write_axis(hdf5::File& file, std::size_t position, const StudyAxis& axis) {
  const auto group = "/axes/" + axis.name;
  file.create_group(group);
  file.set_attribute(group, "position", static_cast<std::int64_t>(position));
  file.set_attribute(group, "keys", joined(axis.keys, " "));
  std::vector<std::string> labels;
  std::vector<double> numbers;
  for (const auto& value : axis.values) {
    labels.push_back(value.label);
    if (value.number) numbers.push_back(*value.number);
  }
  write_texts(file, group + "/label", labels, "what each value is called");
  if (numbers.size() == labels.size())
    write_numbers(file, group + "/number", Element::real64, {numbers.size()}, numbers, axis.unit,
                  "the number in each value; no unit: SI, or a plain number");
}

void write_runs(hdf5::File& file, const Study& study, const StudyOutcome& outcome) {
  std::vector<std::string> status, message;
  std::vector<std::int32_t> values;
  for (std::size_t run = 0; run < outcome.runs.size(); ++run) {
    status.emplace_back(status_text(outcome.runs[run].status));
    message.push_back(outcome.runs[run].message);
    for (const auto chosen : study.combination(run)) values.push_back(static_cast<std::int32_t>(chosen));
  }
  file.create_group("/runs");
  write_texts(file, "/runs/name", outcome.names, "of the run's result, without .h5");
  write_texts(file, "/runs/status", status, "done or failed");
  write_texts(file, "/runs/message", message, "why a run failed");
  write_numbers(file, "/runs/value", Element::int32, {outcome.runs.size(), study.axes.size()}, values, "1",
                "which value of each axis a run has, from 0");
}

}  // namespace

void write_study_file(const fs::path& path, const Study& study, const StudyOutcome& outcome) {
  auto temporary = path;
  temporary += ".tmp";
  auto file = hdf5::File::create(temporary);
  file.set_attribute("/", "format", std::string("sundrape study"));
  file.set_attribute("/", "format_version", std::int64_t{1});
  file.set_attribute("/", "sundrape_version", version());
  file.set_attribute("/", "title", study.title);
  file.set_attribute("/", "study", study.text);
  file.create_group("/axes");
  for (std::size_t a = 0; a < study.axes.size(); ++a) write_axis(file, a, study.axes[a]);
  write_runs(file, study, outcome);
  file.create_group("/outputs");
  for (std::size_t k = 0; k < study.outputs.size(); ++k) {
    const auto& output = study.outputs[k];
    if (is_timing(output)) continue;
    std::vector<double> column;
    column.reserve(outcome.table.values.size());
    for (const auto& row : outcome.table.values) column.push_back(row[k]);
    write_numbers(file, "/outputs/" + output.name, Element::real64, {column.size()}, column, output.unit,
                  output.expression.text());
  }
  file.close();
  fs::rename(temporary, path);
}

}  // namespace sundrape

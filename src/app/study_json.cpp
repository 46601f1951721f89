#include <cmath>

#include <nlohmann/json.hpp>

#include "sundrape/app/study_report.hpp"

#include "study_labels.hpp"

namespace sundrape {
namespace {

nlohmann::json to_json(const StudyFigure& figure) {
  nlohmann::json json{{"name", figure.name},   {"x", figure.x},           {"y", figure.y},
                      {"by", figure.by},       {"curves", figure.curves}, {"panels", figure.panels},
                      {"log_x", figure.log_x}, {"log_y", figure.log_y}};
  if (figure.slope) json["slope"] = *figure.slope;
  return json;
}

}  // namespace

nlohmann::json study_json(const Study& study, const StudyOutcome& outcome, const std::filesystem::path& folder) {
  const auto file = [&](std::size_t run) { return outcome.runs[run].result.lexically_relative(folder).string(); };
  nlohmann::json json{{"format", "sundrape study"},      {"title", study.title},
                      {"study", study.file.string()},    {"case", study.case_file.string()},
                      {"axes", nlohmann::json::array()}, {"groups", nlohmann::json::array()},
                      {"runs", nlohmann::json::array()}};
  if (study.branches) json.update({{"same_shape", study.branches->same_shape}, {"group_by", axis_names(study, true)}});
  if (outcome.reference)
    json["reference"] = {{"result", outcome.reference->result.lexically_relative(folder).string()},
                         {"status", status_text(outcome.reference->status)},
                         {"message", outcome.reference->message}};
  for (const auto& output : study.outputs)
    json["outputs"].push_back({{"name", output.name},
                               {"value", output.expression.text()},
                               {"unit", output.unit},
                               {"timing", is_timing(output)}});
  for (const auto& figure : study.figures) json["figures"].push_back(to_json(figure));
  for (const auto& axis : study.axes) {
    std::vector<std::string> values;
    values.reserve(axis.values.size());
    for (const auto& value : axis.values) values.push_back(value.label);
    json["axes"].push_back({{"name", axis.name}, {"keys", axis.keys}, {"values", values}, {"unit", axis.unit}});
    for (const auto& value : axis.values)
      if (value.number) json["axes"].back()["numbers"].push_back(*value.number);
  }
  for (const auto& group : outcome.groups) {
    nlohmann::json entry{{"values", group_values(study, group)},
                         {"diagonal_m", group.diagonal},
                         {"symmetries", group.symmetries},
                         {"neutral_slides", group.neutral.slides.size()},
                         {"neutral_turn", group.neutral.pivot.has_value()},
                         {"drapes", nlohmann::json::array()}};
    for (const auto& drape : group.drapes) {
      std::vector<std::string> members;
      members.reserve(drape.members.size());
      for (const auto run : drape.members) members.push_back(outcome.names[run]);
      nlohmann::json d = to_json(*outcome.ends[drape.representative]);
      d.update({{"count", drape.members.size()},
                {"runs", members},
                {"labels", run_labels(study, drape.members)},
                {"spread_m", drape.spread},
                {"representative", file(drape.representative)}});
      entry["drapes"].push_back(std::move(d));
    }
    json["groups"].push_back(std::move(entry));
  }
  for (std::size_t run = 0; run < outcome.runs.size(); ++run) {
    nlohmann::json entry = outcome.ends[run] ? to_json(*outcome.ends[run]) : nlohmann::json::object();
    for (std::size_t a = 0; a < study.axes.size(); ++a) entry["values"][study.axes[a].name] = study.value(run, a).label;
    for (std::size_t k = 0; k < study.outputs.size(); ++k)
      if (std::isfinite(outcome.table.values[run][k]))
        entry["outputs"][study.outputs[k].name] = outcome.table.values[run][k];
    const auto place = place_of(outcome, run);
    if (place.drape) entry.update({{"group", place.group}, {"drape", *place.drape + 1}});
    entry.update({{"name", outcome.names[run]},
                  {"result", file(run)},
                  {"status", status_text(outcome.runs[run].status)},
                  {"reused", outcome.runs[run].reused}});
    if (!outcome.runs[run].message.empty()) entry["message"] = outcome.runs[run].message;
    json["runs"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace sundrape

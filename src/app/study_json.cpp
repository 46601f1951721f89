#include <nlohmann/json.hpp>

#include "sundrape/app/study_report.hpp"

#include "study_labels.hpp"

namespace sundrape {

nlohmann::json study_json(const Study& study, const StudyOutcome& outcome, const std::filesystem::path& folder) {
  const auto file = [&](std::size_t run) { return outcome.runs[run].result.lexically_relative(folder).string(); };
  nlohmann::json json{{"format", "sundrape study"},      {"title", study.title},
                      {"study", study.file.string()},    {"case", study.case_file.string()},
                      {"same_shape", study.same_shape},  {"group_by", axis_keys(study, true)},
                      {"axes", nlohmann::json::array()}, {"groups", nlohmann::json::array()},
                      {"runs", nlohmann::json::array()}};
  for (const auto& axis : study.axes) {
    std::vector<std::string> values;
    values.reserve(axis.values.size());
    for (const auto& value : axis.values) values.push_back(shown(value));
    json["axes"].push_back({{"key", axis.key}, {"values", values}});
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
    const auto chosen = study.combination(run);
    for (std::size_t a = 0; a < study.axes.size(); ++a)
      entry["values"][study.axes[a].key] = shown(study.axes[a].values[chosen[a]]);
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

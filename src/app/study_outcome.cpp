#include "sundrape/app/study_outcome.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/app/shape_distance.hpp"
#include "sundrape/io/case_reader.hpp"

namespace sundrape {
namespace {

constexpr std::size_t trial_ends = 4;      // end states that the symmetries of a group are tried at
constexpr std::size_t longest_name = 120;  // file systems take 255

Eigen::MatrixXd distances(const CaseSymmetries& symmetries, int nodes, const std::vector<const EndState*>& ends) {
  const auto n = static_cast<Eigen::Index>(ends.size());
  Eigen::MatrixXd apart = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      apart(i, j) = apart(j, i) =
          shape_distance(symmetries, nodes, ends[static_cast<std::size_t>(i)]->q, ends[static_cast<std::size_t>(j)]->q)
              .rms;
  return apart;
}

/// Fills a group in from its runs' end states.
void sort_group(const Study& study, const StudyOutcome& outcome, const CaseModel& model, StudyGroup& group) {
  std::vector<const EndState*> ends;
  std::vector<double> energies;
  std::vector<Vector> trials;
  for (const auto run : group.runs) {
    ends.push_back(&*outcome.ends[run]);
    energies.push_back(ends.back()->total_energy);
    if (trials.size() < trial_ends) trials.push_back(ends.back()->q);
  }
  const auto symmetries = find_case_symmetries(model, trials);
  group.diagonal = diagonal(model.mesh);
  group.symmetries = symmetries.maps.size();
  group.neutral = symmetries.neutral;
  group.drapes = sort_into_drapes(distances(symmetries, model.mesh.nodes(), ends), energies,
                                  study.branches->same_shape * group.diagonal);
  for (auto& drape : group.drapes) {
    for (auto& member : drape.members) member = group.runs[member];
    drape.representative = group.runs[drape.representative];
  }
}

/// Fills in the ends of runs and their drapes.
void sort_drapes(const Study& study, StudyOutcome& outcome) {
  std::map<std::vector<std::size_t>, StudyGroup> groups;  // by the values of the group axes
  for (std::size_t run = 0; run < outcome.runs.size(); ++run) {
    auto values = study.group_of(run);
    auto& group = groups[values];
    group.values = std::move(values);
    if (outcome.runs[run].status == BatchStatus::done) group.runs.push_back(run);
  }
  for (auto& [values, group] : groups) {
    std::optional<CaseModel> first;
    for (const auto run : group.runs) {
      const Case c = read_case(study.case_file, study.settings(run));
      outcome.ends[run] = end_state(weighing_model(c), ResultReader(outcome.runs[run].result));
      if (!first) first = perfect_model(c);
    }
    if (first) sort_group(study, outcome, *first, group);
    outcome.groups.push_back(std::move(group));
  }
}

std::string file_safe(std::string text) {
  std::erase(text, '"');
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string_view("._+-").find(c) == std::string_view::npos)
      c = '_';
  return text;
}

}  // namespace

std::vector<std::string> run_names(const Study& study) {
  std::map<std::string, int> count;
  const auto last_part = [](const std::string& key) { return key.substr(key.rfind('.') + 1); };
  for (const auto& axis : study.axes) ++count[last_part(axis.name)];
  std::vector<std::string> names;
  for (std::size_t run = 0; run < study.runs(); ++run) {
    std::vector<std::string> parts;
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
      const auto& name = study.axes[a].name;
      const auto part = last_part(name);
      parts.push_back(file_safe(count[part] > 1 ? name : part) + "=" + file_safe(study.value(run, a).label));
    }
    names.push_back(fmt::format("{}", fmt::join(parts, ",")));
  }
  const bool unique = std::set<std::string>(names.begin(), names.end()).size() == names.size();
  const bool short_enough = std::ranges::all_of(names, [](const auto& name) { return name.size() <= longest_name; });
  if (!unique || !short_enough)
    for (std::size_t run = 0; run < names.size(); ++run) names[run] = fmt::format("run-{:04}", run + 1);
  return names;
}

StudyOutcome study_outcome(const Study& study, std::vector<std::string> names, std::vector<BatchOutcome> runs,
                           std::optional<BatchOutcome> reference, int jobs) {
  StudyOutcome outcome{.names = std::move(names),
                       .runs = std::move(runs),
                       .reference = std::move(reference),
                       .table = {},
                       .ends = {},
                       .groups = {}};
  outcome.table = study_table(study, outcome.runs, outcome.reference, jobs);
  outcome.ends.resize(outcome.runs.size());
  if (study.branches) sort_drapes(study, outcome);
  return outcome;
}

}  // namespace sundrape

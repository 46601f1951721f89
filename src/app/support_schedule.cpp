#include "sundrape/app/support_schedule.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "sundrape/integrate/integrator.hpp"

namespace sundrape {
namespace {

std::vector<Vector3> node_positions(const CaseModel& model, const State& all) {
  std::vector<Vector3> positions;
  positions.reserve(static_cast<std::size_t>(model.mesh.nodes()));
  for (int n = 0; n < model.mesh.nodes(); ++n) positions.emplace_back(point(all.q, n));
  return positions;
}

}  // namespace

SupportSchedule::SupportSchedule(const CaseModel& model) : model_(model) {
  for (std::size_t g = 0; g < model.grippers.size(); ++g) {
    const auto& grip = model.grippers[g].grip;
    if (grip.from) changes_.push_back({*grip.from, true, g});
    if (grip.until) changes_.push_back({*grip.until, false, g});
  }
  // who opens at an instant does so before others close
  std::ranges::stable_sort(changes_, [](const Change& a, const Change& b) {
    return std::pair(a.time, a.closes) < std::pair(b.time, b.closes);
  });
}

double SupportSchedule::next() const {
  return done_ < changes_.size() ? changes_[done_].time : std::numeric_limits<double>::infinity();
}

void SupportSchedule::happen(const State& all) {
  for (; done_ < changes_.size() && changes_[done_].time <= all.time; ++done_) {
    const auto& change = changes_[done_];
    const auto& gripper = model_.grippers[change.gripper];
    change.closes ? close(gripper, all) : open(gripper, all);
  }
}

std::vector<int> SupportSchedule::within_reach(const CaseModel::Gripper& gripper, const State& all) const {
  auto nodes = select(gripper.nodes, model_.mesh, node_positions(model_, all));
  if (const auto* near = std::get_if<Near>(&gripper.nodes)) {
    const double reach = mean_edge_length(model_.mesh);
    std::erase_if(nodes, [&](int n) { return (point(all.q, n) - near->point).norm() > reach; });
  }
  return nodes;
}

void SupportSchedule::close(const CaseModel::Gripper& gripper, const State& all) {
  const auto nodes = within_reach(gripper, all);
  if (nodes.empty()) {
    Vector3 low = point(all.q, 0), high = low;
    for (const auto& x : node_positions(model_, all)) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    throw IntegrationFailure(fmt::format(
        "'{}' grips nothing at t = {:.6g} s: no node of the cloth is there. The cloth is then between ({:.4g}, {:.4g}, "
        "{:.4g}) m and ({:.4g}, {:.4g}, {:.4g}) m; change `nodes` or `grip`, or choose a named set, which is gripped "
        "wherever it is",
        gripper.name, all.time, low.x(), low.y(), low.z(), high.x(), high.y(), high.z()));
  }
  model_.system->take_hold(gripper.motion, nodes, model_.turned_points(gripper, nodes), all);
}

void SupportSchedule::open(const CaseModel::Gripper& gripper, const State& all) {
  if (gripper.turns)
    for (auto* clamps : model_.clamps) clamps->open(model_.system->motion(gripper.motion).points);
  model_.system->let_go(gripper.motion, all);
}

std::vector<double> SupportSchedule::progress() const {
  if (changes_.empty()) return {};
  std::vector<double> list{static_cast<double>(done_)};
  for (std::size_t g = 0; g < model_.grippers.size(); ++g)
    for (const int n : model_.system->motion(model_.grippers[g].motion).points)
      list.insert(list.end(), {static_cast<double>(g), static_cast<double>(n)});
  return list;
}

void SupportSchedule::resume(const std::vector<double>& progress, const State& all) {
  if (progress.empty()) return;
  done_ = static_cast<std::size_t>(progress[0]);
  for (std::size_t g = 0; g < model_.grippers.size(); ++g) {
    const auto& gripper = model_.grippers[g];
    std::vector<int> nodes;
    for (std::size_t k = 1; k + 1 < progress.size(); k += 2)
      if (static_cast<std::size_t>(progress[k]) == g) nodes.push_back(static_cast<int>(progress[k + 1]));
    const bool held_at_the_start = !model_.system->motion(gripper.motion).points.empty();
    if (held_at_the_start && nodes.empty()) open(gripper, all);
    if (held_at_the_start) model_.system->let_go(gripper.motion, all);
    if (!nodes.empty()) model_.system->take_hold(gripper.motion, nodes, model_.turned_points(gripper, nodes), all);
  }
}

}  // namespace sundrape

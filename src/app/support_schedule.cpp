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
  std::ranges::sort(changes_, {}, &Change::time);
  constexpr double same = 1e-12;  // relative: no integrator makes a step in between
  for (std::size_t k = 1; k < changes_.size(); ++k)
    if (changes_[k].time - changes_[k - 1].time < same * changes_[k].time) changes_[k].time = changes_[k - 1].time;
  // who opens at an instant does so before others close
  std::ranges::stable_sort(changes_, [](const Change& a, const Change& b) {
    return std::pair(a.time, a.closes) < std::pair(b.time, b.closes);
  });
  for (const auto& gripper : model.grippers) held_.push_back(gripper.at_start);
}

double SupportSchedule::next() const {
  return done_ < changes_.size() ? changes_[done_].time : std::numeric_limits<double>::infinity();
}

void SupportSchedule::happen(const State& all) {
  for (; done_ < changes_.size() && changes_[done_].time <= all.time; ++done_) {
    const auto& change = changes_[done_];
    change.closes ? close(change.gripper, all) : open(change.gripper, all);
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

void SupportSchedule::take(std::size_t index, std::vector<int> nodes, const State& all) {
  const auto& gripper = model_.grippers[index];
  model_.system->take_hold(gripper.motion, nodes, model_.turned_points(gripper, nodes), all);
  held_[index] = std::move(nodes);
}

void SupportSchedule::let_go(std::size_t index, const State& all) {
  model_.system->let_go(model_.grippers[index].motion, all);
  held_[index].clear();
}

void SupportSchedule::close(std::size_t index, const State& all) {
  const auto& gripper = model_.grippers[index];
  auto nodes = within_reach(gripper, all);
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
  const auto& rows = model_.system->unknowns().row_of_point();
  if (gripper.moves)
    for (const int n : nodes)
      if (rows[static_cast<std::size_t>(n)] < 0)
        throw IntegrationFailure(
            fmt::format("'{}' grips node {} at t = {:.6g} s, which another support holds for good: "
                        "nothing can carry it away",
                        gripper.name, n, all.time));
  take(index, std::move(nodes), all);
}

void SupportSchedule::open(std::size_t index, const State& all) {
  if (model_.grippers[index].turns) {
    std::vector<bool> clamped = model_.clamped_for_good;
    for (std::size_t g = 0; g < held_.size(); ++g)
      if (g != index && model_.grippers[g].turns)
        for (const int n : held_[g]) clamped[static_cast<std::size_t>(n)] = true;
    std::vector<int> opened = held_[index];
    std::erase_if(opened, [&](int n) { return clamped[static_cast<std::size_t>(n)]; });
    for (auto* clamps : model_.clamps) clamps->open(opened);
  }
  let_go(index, all);
}

std::vector<double> SupportSchedule::progress() const {
  if (changes_.empty()) return {};
  std::vector<double> list{static_cast<double>(done_)};
  for (std::size_t g = 0; g < held_.size(); ++g)
    for (const int n : held_[g]) list.insert(list.end(), {static_cast<double>(g), static_cast<double>(n)});
  return list;
}

void SupportSchedule::resume(const std::vector<double>& progress, const State& all) {
  if (progress.empty()) return;
  done_ = static_cast<std::size_t>(progress[0]);
  std::vector<std::vector<int>> nodes(held_.size());
  for (std::size_t k = 1; k + 1 < progress.size(); k += 2)
    nodes.at(static_cast<std::size_t>(progress[k])).push_back(static_cast<int>(progress[k + 1]));
  for (std::size_t g = 0; g < held_.size(); ++g) {
    if (!held_[g].empty()) nodes[g].empty() ? open(g, all) : let_go(g, all);
    if (!nodes[g].empty()) take(g, std::move(nodes[g]), all);
  }
  model_.system->go_on_from(all);
}

}  // namespace sundrape

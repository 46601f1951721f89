#pragma once
#include <vector>

#include "sundrape/app/model.hpp"
#include "sundrape/integrate/timetable.hpp"

namespace sundrape {

/// The grippers of a case that close and open in time.
///
/// A gripper that closes holds the nodes that are then where its selector says, or those of the named set; `near` is
/// the closest node within one mean edge of the cloth.
class SupportSchedule final : public Timetable {
 public:
  explicit SupportSchedule(const CaseModel& model);

  [[nodiscard]] double next() const override;
  /// @throws IntegrationFailure  a gripper closes where there is no cloth, or on what it cannot carry away
  void happen(const State& all) override;

  /// For checkpoints: how many changes have happened, then gripper and node for every node that is held now. Empty if
  /// nothing ever changes.
  [[nodiscard]] std::vector<double> progress() const;
  /// As it stood when an interrupted run wrote it, at the state that it goes on from.
  void resume(const std::vector<double>& progress, const State& all);

 private:
  struct Change {
    double time = 0;  // [s]
    bool closes = false;
    std::size_t gripper = 0;
  };
  void close(std::size_t gripper, const State& all);
  void open(std::size_t gripper, const State& all);
  void take(std::size_t gripper, std::vector<int> nodes, const State& all);
  void let_go(std::size_t gripper, const State& all);
  [[nodiscard]] std::vector<int> within_reach(const CaseModel::Gripper& gripper, const State& all) const;

  const CaseModel& model_;
  std::vector<Change> changes_;         // in the order of time
  std::vector<std::vector<int>> held_;  // nodes of each gripper
  std::size_t done_ = 0;
};

}  // namespace sundrape

#pragma once
#include <optional>
#include <string>

#include "sundrape/app/model.hpp"

namespace sundrape {

/// Watches for what ends a run though the equations go on: cloth that is torn, and supports and obstacles that run into
/// each other.
class Mishaps {
 public:
  Mishaps(const Case& c, const CaseModel& model);

  /// What has happened at a state and what to try; nothing if all is well.
  [[nodiscard]] std::optional<std::string> at(const State& all) const;

 private:
  struct HeldNode {
    int node = -1;
    double gap = 0;  // at the start [m]
  };
  [[nodiscard]] std::optional<std::string> tear(const State& all) const;
  [[nodiscard]] std::optional<std::string> collision(const State& all) const;

  const Case& case_;
  const CaseModel& model_;
  std::vector<HeldNode> held_;  // where supports or obstacles move
};

}  // namespace sundrape

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
  [[nodiscard]] std::optional<std::string> tear(const State& all) const;
  [[nodiscard]] std::optional<std::string> collision(const State& all) const;

  const Case& case_;
  const CaseModel& model_;
  std::vector<double> lowest_gaps_;  // of each node to obstacles [m]: a thickness into one; where something moves
};

}  // namespace sundrape

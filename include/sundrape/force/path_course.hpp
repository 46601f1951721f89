#pragma once
#include "sundrape/force/load_course.hpp"
#include "sundrape/mesh/rigid_path.hpp"

namespace sundrape {

/// When a path is travelled: over time, or in the stages of staged statics.
struct PathTiming {
  enum class Profile { smooth, linear };
  double start = 0, duration = 0;     // [s]; a path of no duration has been travelled from the start
  Profile profile = Profile::smooth;  // C² at both ends, or at constant speed
  std::vector<double> stages{1};      // shares at the ends of the stages; the last one is the end of the path in time

  [[nodiscard]] double share(const State& state) const;
  /// ∂share/∂t [1/s]; 0 in staged statics.
  [[nodiscard]] double share_rate(const State& state) const;
  [[nodiscard]] double end() const { return start + duration; }  // [s]
};

/// A path with its timing: where what is carried along it stands at any state.
struct PathCourse {
  RigidPath path;
  PathTiming timing = {};

  [[nodiscard]] RigidPlacement placement(const State& state) const {
    return placement_along(path, timing.share(state));
  }
  [[nodiscard]] RigidRate rate(const State& state) const {
    return timing.share_rate(state) * rate_along(path, timing.share(state));
  }
};

}  // namespace sundrape

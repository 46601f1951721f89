#pragma once
#include "path_corrector.hpp"

namespace sundrape {

/// A point of the path whose negative pivots are known.
struct AssessedPoint {
  PathPoint at;
  int negative_pivots = 0;
};

/// The critical point between two equilibria that differ in their negative pivots: the first one, if there are several.
/// Nothing where no path from one to the other is found. The tangent is factored elsewhere afterwards.
/// @param limit_point  whether the load turns round between them
[[nodiscard]] std::optional<CriticalPoint> locate_critical_point(StageSolver& s, const AssessedPoint& before,
                                                                 const AssessedPoint& after, bool limit_point);

/// All critical points between two equilibria in their order, each told to `met`, until that returns false.
/// @param limit_point  whether the load turns round at the first of them
/// @returns the point from which on no path to `after` was found; nothing where every change of pivots is explained
[[nodiscard]] std::optional<AssessedPoint> each_critical_point(StageSolver& s, const AssessedPoint& before,
                                                               const AssessedPoint& after, bool limit_point,
                                                               const std::function<bool(const CriticalPoint&)>& met);

}  // namespace sundrape

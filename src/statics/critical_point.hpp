#pragma once
#include "path_corrector.hpp"

namespace sundrape {

/// A point of the path with what tells it from its neighbours.
struct JudgedPoint {
  PathPoint at;
  int negative_pivots = 0;
};

/// The critical point between two equilibria that differ in their negative pivots: the first one, if there are several.
/// Nothing where no path from one to the other is found. The tangent is factored elsewhere afterwards.
/// @param limit_point  whether the load turns round between them
[[nodiscard]] std::optional<CriticalPoint> locate_critical_point(StageSolver& s, const JudgedPoint& before,
                                                                 const JudgedPoint& after, bool limit_point);

/// A mode as displacements of all points, 3P, the largest of a node or director 1.
[[nodiscard]] Vector displacements(const System& system, const Vector& mode);

}  // namespace sundrape

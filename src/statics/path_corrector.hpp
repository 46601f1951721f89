#pragma once
#include <functional>

#include "sundrape/statics/equilibrium_path.hpp"

namespace sundrape {

/// What the solvers of one stage share.
struct StageSolver {
  StagedEquilibrium equations;
  Tangent& tangent;
  const PathOptions& options;
  const System& system;

  /// Scaled product of two increments, rows [m] and load factors: the metric of (19).
  [[nodiscard]] double dot(const Vector& a, double a_load, const Vector& b, double b_load) const {
    return a.dot(b) / (options.size * options.size) + a_load * b_load;
  }
  [[nodiscard]] Vector rows(const Vector& all) const {
    Vector gathered(system.unknowns().size());
    system.unknowns().gather(all, gathered);
    return gathered;
  }
};

/// A point near the path, or on it.
struct PathPoint {
  Vector q;  // 3P [m]
  double load_factor = 0;
};

/// How Newton's method went.
struct Correction {
  bool converged = false;
  int iterations = 0;
  double residual = 0;  // at the end
  int rises = 0;        // iterations that ended with a larger residual than they began with
};

/// Told about every residual: iteration from 1 on, load factor, |out-of-balance force| / |loads|.
using ResidualReport = std::function<void(int, double, double)>;

/// To equilibrium at a distance `length` (19) from `from`, by (21) and (22).
[[nodiscard]] Correction correct_on_arc(StageSolver& s, const PathPoint& from, double length, PathPoint& at,
                                        const ResidualReport& report);
/// To equilibrium in the plane through `at` that is normal to an increment (rows, load).
[[nodiscard]] Correction correct_on_plane(StageSolver& s, const Vector& normal, double normal_load, PathPoint& at);
/// To equilibrium at a given load factor, with a line search.
[[nodiscard]] Correction correct_at_load(StageSolver& s, PathPoint& at, const ResidualReport& report);

}  // namespace sundrape

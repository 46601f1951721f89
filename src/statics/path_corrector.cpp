#include "path_corrector.hpp"

#include <cmath>
#include <functional>

namespace sundrape {
namespace {

constexpr double hopeless = 1e12;  // residual over the loads
constexpr double enough = 0.8;     // of the work along a Newton step that a line search leaves at most

/// The two solutions that every correction is made of, (23) and (24).
struct Solutions {
  Vector by_load, by_residual;  // u^I, u^II: rows [m]
  bool ok = false;
};

Solutions solve_both(StageSolver& s, const PathPoint& at, const Vector& residual) {
  Solutions u{Vector(residual.size()), Vector(residual.size())};
  const Vector load = s.equations.load_direction(at.q, at.load_factor);
  u.ok = s.tangent.factor(s.equations.state(at.q, at.load_factor)) == FactorStatus::ok &&
         s.tangent.solve(load, u.by_load).ok && s.tangent.solve(residual, u.by_residual).ok;
  return u;
}

/// Newton's iterations; `advance` makes one correction from a residual and returns whether it could.
template <class Advance>
Correction iterate(StageSolver& s, PathPoint& at, const ResidualReport& report, Advance advance) {
  Correction c;
  for (;; ++c.iterations) {
    const Vector residual = s.equations.out_of_balance(at.q, at.load_factor);
    c.residual = residual.norm() / s.equations.force_scale(at.q, at.load_factor);
    if (report) report(c.iterations + 1, at.load_factor, c.residual);
    if (!std::isfinite(c.residual) || c.residual > hopeless) return c;
    if (c.residual <= s.options.tolerance) {
      c.converged = true;
      return c;
    }
    if (c.iterations >= s.options.max_iterations || !advance(residual)) return c;
  }
}

/// Rows that move by more than anything sensible mean a tangent that is all but singular.
bool sensible(const StageSolver& s, const Vector& increment) {
  return increment.allFinite() && increment.cwiseAbs().maxCoeff() < 10 * s.options.size;
}

}  // namespace

Correction correct_on_arc(StageSolver& s, const PathPoint& from, double length, PathPoint& at,
                          const ResidualReport& report) {
  const Vector start = s.rows(from.q);
  return iterate(s, at, report, [&](const Vector& residual) {
    const auto u = solve_both(s, at, residual);
    if (!u.ok) return false;
    const Vector way = s.rows(at.q) - start;
    const double way_load = at.load_factor - from.load_factor;
    const double distance = std::sqrt(s.dot(way, way_load, way, way_load)), f = distance - length;  // (19)
    const double slope = s.dot(way, way_load, u.by_load, 1);
    const double load = -(f * distance + s.dot(way, way_load, u.by_residual, 0)) / slope;  // (21)
    const Vector increment = load * u.by_load + u.by_residual;                             // (22)
    if (!std::isfinite(load) || !sensible(s, increment)) return false;
    at.load_factor += load;
    s.equations.move(at.q, increment, at.load_factor);
    return true;
  });
}

Correction correct_on_plane(StageSolver& s, const Vector& normal, double normal_load, PathPoint& at) {
  return iterate(s, at, {}, [&](const Vector& residual) {
    const auto u = solve_both(s, at, residual);
    if (!u.ok) return false;
    const double load = -s.dot(normal, normal_load, u.by_residual, 0) / s.dot(normal, normal_load, u.by_load, 1);
    const Vector increment = load * u.by_load + u.by_residual;
    if (!std::isfinite(load) || !sensible(s, increment)) return false;
    at.load_factor += load;
    s.equations.move(at.q, increment, at.load_factor);
    return true;
  });
}

Correction correct_at_load(StageSolver& s, PathPoint& at, const ResidualReport& report) {
  return iterate(s, at, report, [&](const Vector& residual) {
    Vector step(residual.size());
    if (s.tangent.factor(s.equations.state(at.q, at.load_factor)) != FactorStatus::ok ||
        !s.tangent.solve(residual, step).ok || !sensible(s, step))
      return false;
    // regula falsi on the work of the residual along the step, which vanishes where the energy is least
    const double work = step.dot(residual);
    const Vector start = at.q;
    double low = 0, high = 1, low_work = work;
    for (int k = 0; k < 6; ++k) {
      at.q = start;
      s.equations.move(at.q, high * step, at.load_factor);
      const double rest = step.dot(s.equations.out_of_balance(at.q, at.load_factor));
      if (std::abs(rest) <= enough * std::abs(work)) break;
      if (rest * low_work > 0) break;  // the zero lies beyond: go there next time
      const double next = high - rest * (high - low) / (rest - low_work);
      high = std::max(next, low + 0.1 * (high - low));
    }
    return true;
  });
}

}  // namespace sundrape

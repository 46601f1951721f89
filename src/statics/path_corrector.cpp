#include "path_corrector.hpp"

#include <cmath>
#include <functional>
#include <limits>

namespace sundrape {
namespace {

constexpr double hopeless = 1e12;  // residual over the loads
constexpr double enough = 0.8;     // of the work along a Newton step that a line search leaves at most

/// Rows that move by more than anything sensible mean a tangent that is all but singular.
bool sensible(const StageSolver& s, const Vector& increment) {
  return increment.allFinite() && increment.cwiseAbs().maxCoeff() < 10 * s.options.size;
}

/// One correction (22): Δλ u^I + u^II with u^I = K⁻¹F_0 (23), u^II = K⁻¹(F − P) (24), and the Δλ that a constraint on
/// them demands, load_for(u^I, u^II). False where the tangent gives none.
template <class LoadFor>
bool correct(StageSolver& s, PathPoint& at, const Vector& residual, LoadFor load_for) {
  Vector by_load(residual.size()), by_residual(residual.size());
  const Vector load_direction = s.equations.load_direction(at.q, at.load_factor);
  if (s.tangent.factor(s.equations.state(at.q, at.load_factor)) != FactorStatus::ok ||
      !s.tangent.solve(load_direction, by_load).ok || !s.tangent.solve(residual, by_residual).ok)
    return false;
  const double load = load_for(by_load, by_residual);
  const Vector increment = load * by_load + by_residual;
  if (!std::isfinite(load) || !sensible(s, increment)) return false;
  at.load_factor += load;
  s.equations.move(at.q, increment, at.load_factor);
  return true;
}

/// Newton's iterations; `advance` makes one correction from a residual and returns whether it could.
template <class Advance>
Correction iterate(StageSolver& s, PathPoint& at, const ResidualReport& report, Advance advance) {
  Correction c;
  double before = std::numeric_limits<double>::infinity();
  for (;; ++c.iterations) {
    const Vector residual = s.equations.out_of_balance(at.q, at.load_factor);
    c.residual = residual.norm() / s.equations.force_scale(at.q, at.load_factor);
    if (c.residual > before) ++c.rises;
    before = c.residual;
    if (report) report(c.iterations + 1, at.load_factor, c.residual);
    if (!std::isfinite(c.residual) || c.residual > hopeless) return c;
    if (c.residual <= s.options.tolerance) {
      c.converged = true;
      return c;
    }
    if (c.iterations >= s.options.max_iterations || !advance(residual)) return c;
  }
}

}  // namespace

Correction correct_on_arc(StageSolver& s, const PathPoint& from, double length, PathPoint& at,
                          const ResidualReport& report) {
  const Vector start = s.rows(from.q);
  return iterate(s, at, report, [&](const Vector& residual) {
    const Vector way = s.rows(at.q) - start;
    const double way_load = at.load_factor - from.load_factor;
    const double distance = std::sqrt(s.dot(way, way_load, way, way_load)), f = distance - length;  // (19)
    return correct(s, at, residual, [&](const Vector& by_load, const Vector& by_residual) {
      return -(f * distance + s.dot(way, way_load, by_residual, 0)) / s.dot(way, way_load, by_load, 1);  // (21)
    });
  });
}

Correction correct_on_plane(StageSolver& s, const Vector& normal, double normal_load, PathPoint& at) {
  return iterate(s, at, {}, [&](const Vector& residual) {
    return correct(s, at, residual, [&](const Vector& by_load, const Vector& by_residual) {
      return -s.dot(normal, normal_load, by_residual, 0) / s.dot(normal, normal_load, by_load, 1);
    });
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

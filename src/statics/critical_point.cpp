#include "critical_point.hpp"

#include <algorithm>
#include <cmath>

namespace sundrape {
namespace {

constexpr int most_trials = 25;
constexpr int most_in_a_step = 6;
constexpr double wanted = 1e-4;  // uncertainty of the load factor, relative

/// φ·K φ of a mode at an equilibrium, whose zero is looked for.
double quotient(const Tangent& tangent, const Vector& mode) {
  Vector product(mode.size());
  tangent.matrix().multiply(mode, product);
  return mode.dot(product);
}

/// Whether an equilibrium found between two others is further from both than they are from each other: one of another
/// branch.
bool strays(const StageSolver& s, const PathPoint& a, const PathPoint& b, const PathPoint& middle) {
  const auto distance = [&](const PathPoint& x, const PathPoint& y) {
    const Vector way = s.rows(y.q) - s.rows(x.q);
    const double load = y.load_factor - x.load_factor;
    return std::sqrt(s.dot(way, load, way, load));
  };
  const double most = 1.5 * distance(a, b);
  return distance(a, middle) > most || distance(middle, b) > most;
}

}  // namespace

std::optional<CriticalPoint> locate_critical_point(StageSolver& s, const AssessedPoint& before,
                                                   const AssessedPoint& after, bool limit_point) {
  const auto& system = s.system;
  const Vector chord = s.rows(after.at.q) - s.rows(before.at.q);
  const double chord_load = after.at.load_factor - before.at.load_factor;
  const auto factor = [&](const PathPoint& at) {
    return s.tangent.factor(s.equations.state(at.q, at.load_factor)) == FactorStatus::ok;
  };
  // The mode that is about to be lost is told best where it is unstable.
  const auto& worse = after.negative_pivots > before.negative_pivots ? after : before;
  Vector mode = Vector::Zero(chord.size());
  const auto follow_mode = [&](const PathPoint& at) {
    if (!factor(at)) return;
    if (const auto unstable = modes_nearest_to_zero(system, s.tangent, worse.negative_pivots + 3); !unstable.empty()) {
      const auto nearest = std::ranges::find_if(unstable, [](const Mode& m) { return m.eigenvalue < 0; });
      if (nearest != unstable.end()) mode = nearest->shape;
    }
  };
  follow_mode(worse.at);

  AssessedPoint low = before, high = after;
  double low_share = 0, high_share = 1;
  const auto quotient_at = [&](const PathPoint& at) { return factor(at) ? quotient(s.tangent, mode) : 0.0; };
  double low_value = quotient_at(before.at), high_value = quotient_at(after.at);
  for (int trial = 0; trial < most_trials; ++trial) {
    const double span = std::abs(high.at.load_factor - low.at.load_factor);
    const double size = std::max(std::abs(low.at.load_factor), std::abs(high.at.load_factor));
    if (span <= wanted * size && high_share - low_share < 0.01) break;
    // where the mode's stiffness vanishes by interpolation, kept away from both ends; halves every third time
    double share = 0.5 * (low_share + high_share);
    if (low_value * high_value < 0 && trial % 3 != 2) {
      const double guess = low_value / (low_value - high_value), width = high_share - low_share;
      share = low_share + std::clamp(guess, 0.02, 0.98) * width;
    }
    const double part = (share - low_share) / (high_share - low_share);
    PathPoint middle{low.at.q, low.at.load_factor + part * (high.at.load_factor - low.at.load_factor)};
    s.equations.move(middle.q, part * (s.rows(high.at.q) - s.rows(low.at.q)), middle.load_factor);
    if (!correct_on_plane(s, chord, chord_load, middle).converged || !factor(middle)) return std::nullopt;
    const int pivots = s.tangent.negative_pivots().value_or(high.negative_pivots);
    const auto [least, most] = std::minmax(before.negative_pivots, after.negative_pivots);
    if (strays(s, low.at, high.at, middle) || pivots < least || pivots > most) return std::nullopt;
    const double value = quotient(s.tangent, mode);
    if (pivots == before.negative_pivots) {
      low = {middle, pivots};
      low_share = share;
      low_value = value;
    } else {
      high = {middle, pivots};
      high_share = share;
      high_value = value;
    }
  }
  follow_mode(worse.negative_pivots == before.negative_pivots ? low.at : high.at);

  CriticalPoint found;
  found.kind = limit_point ? CriticalPoint::Kind::limit_point : CriticalPoint::Kind::bifurcation;
  found.stage = s.equations.stage();
  found.load_factor = 0.5 * (low.at.load_factor + high.at.load_factor);
  found.uncertainty = 0.5 * std::abs(high.at.load_factor - low.at.load_factor);
  found.q = low.at.q;
  found.mode = displacements(system, mode);
  found.pivots_before = before.negative_pivots;
  found.pivots_after = high.negative_pivots;
  return found;
}

std::optional<AssessedPoint> each_critical_point(StageSolver& s, const AssessedPoint& before,
                                                 const AssessedPoint& after, bool limit_point,
                                                 const std::function<bool(const CriticalPoint&)>& met) {
  AssessedPoint from = before;
  for (int k = 0; k < most_in_a_step && from.negative_pivots != after.negative_pivots; ++k) {
    const auto found = locate_critical_point(s, from, after, limit_point && k == 0);
    if (!found) return from;
    if (!met(*found) || found->pivots_after == from.negative_pivots) break;
    from = {{found->q, found->load_factor}, found->pivots_after};
  }
  return {};
}

}  // namespace sundrape

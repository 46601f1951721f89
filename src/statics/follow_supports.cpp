#include "sundrape/statics/follow_supports.hpp"

#include <algorithm>
#include <utility>

#include "sundrape/statics/staged_equilibrium.hpp"
#include "sundrape/statics/tangent.hpp"

namespace sundrape {
namespace {

constexpr int by_time = 0;           // the stage of a state whose loads and paths go by time
constexpr double cautious = 0.2;     // of the largest move, without a prediction
constexpr double difference = 1e-7;  // of the way, in the speed of supports

/// Largest coordinate by which supports move a second, between two times [m/s].
double speed_of_supports(const System& system, double from, double to, const Vector& q) {
  Vector now = q, then = q;
  const double step = difference * (to - from);
  system.carry(from, by_time, now);
  system.carry(from + step, by_time, then);
  return (then - now).cwiseAbs().maxCoeff() / step;
}

/// Power of supports, obstacles and loads when the free points rest [W].
double power_in(const System& system, double time, const Vector& q) {
  Vector rows(system.unknowns().size()), all_q(q.size()), v(q.size());
  system.unknowns().gather(q, rows);
  system.expand(time, rows, Vector::Zero(rows.size()), all_q, v);
  const State all{time, all_q, v, by_time};
  return system.external_power(all) + system.support_power(all);
}

}  // namespace

FollowResult follow_supports(const System& system, LinearSolver& solver, const FollowOptions& options, double from,
                             double to, Vector& q, RelaxationObserver& observer) {
  const double largest_move = options.relaxation.largest_move;
  Tangent tangent(system, options.neutral_frequency);
  Vector rate(system.unknowns().size());
  FollowResult result;
  result.time = from;
  double power = power_in(system, from, q);
  while (result.time < to) {
    const double remaining = to - result.time;
    StagedEquilibrium equations(system, by_time, q, options.relaxation.force_scale);
    const double carried = speed_of_supports(system, result.time, to, q);
    rate.setZero();
    const bool predicts = tangent.factor(equations.state(q, result.time)) == FactorStatus::ok &&
                          tangent.negative_pivots() == 0 &&
                          tangent.solve(equations.load_direction(q, result.time), rate).ok && rate.allFinite();
    if (!predicts) rate.setZero();
    const double speed = std::max(carried, rate.cwiseAbs().maxCoeff());
    const double reach = predicts ? largest_move : cautious * largest_move;
    const double step = speed * remaining > reach ? reach / speed : remaining;
    const bool last = step == remaining;

    auto relaxation = options.relaxation;
    relaxation.load_factor = last ? to : result.time + step;
    relaxation.stage = by_time;
    if (!last) relaxation.tolerance = std::max(options.loose_tolerance, relaxation.tolerance);
    Vector tried = q;
    equations.move(tried, step * rate, relaxation.load_factor);
    const auto found = relax(system, solver, relaxation, tried, observer);
    auto& total = result.relaxation;
    total.iterations += found.iterations;
    total.factorizations += found.factorizations + 1;
    total.linear_iterations += found.linear_iterations;
    total.end = found.end;
    total.residual = found.residual;
    total.diagnosis = found.diagnosis;
    if (found.end != RelaxationEnd::converged) return result;
    q = tried;
    const double power_before = std::exchange(power, power_in(system, relaxation.load_factor, q));
    result.work += 0.5 * (power_before + power) * (relaxation.load_factor - result.time);
    result.time = relaxation.load_factor;
  }
  return result;
}

}  // namespace sundrape

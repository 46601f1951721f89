#include "sundrape/statics/follow_supports.hpp"

#include <algorithm>

#include "sundrape/statics/staged_equilibrium.hpp"
#include "sundrape/statics/tangent.hpp"

namespace sundrape {
namespace {

constexpr double cautious = 0.2;     // of the largest move, without a prediction
constexpr double difference = 1e-7;  // of the way, in the speed of supports

/// Largest coordinate by which supports move a second, between two times [m/s].
double speed_of_supports(const System& system, double from, double to, const Vector& q) {
  Vector now = q, then = q;
  const double step = difference * (to - from);
  system.carry(from, statics_by_time, now);
  system.carry(from + step, statics_by_time, then);
  return (then - now).cwiseAbs().maxCoeff() / step;
}

/// Work of supports and obstacles that go from one place to another while the free points rest: their forces at one
/// end times the way [J].
double work_over(const System& system, const Vector& q, double time, double from, double to) {
  const Vector still = Vector::Zero(q.size());
  Vector f(q.size()), start = q, end = q;
  system.force({time, q, still, statics_by_time}, f);
  system.carry(from, statics_by_time, start);
  system.carry(to, statics_by_time, end);
  return -f.dot(end - start);
}

}  // namespace

FollowResult follow_supports(const System& system, LinearSolver& solver, const FollowOptions& options, double from,
                             double to, Vector& q, RelaxationObserver& observer) {
  const double largest_move = options.relaxation.largest_move;
  Tangent tangent(system, options.neutral_frequency);
  Vector rate(system.unknowns().size());
  FollowResult result;
  result.time = from;
  while (result.time < to) {
    const double remaining = to - result.time;
    StagedEquilibrium equations(system, statics_by_time, q, options.relaxation.force_scale);
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
    relaxation.stage = statics_by_time;
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
    result.work += 0.5 * (work_over(system, q, result.time, result.time, relaxation.load_factor) +
                          work_over(system, tried, relaxation.load_factor, result.time, relaxation.load_factor));
    q = tried;
    result.time = relaxation.load_factor;
  }
  return result;
}

}  // namespace sundrape

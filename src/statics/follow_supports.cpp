#include "sundrape/statics/follow_supports.hpp"

#include <algorithm>

#include "sundrape/statics/staged_equilibrium.hpp"
#include "sundrape/statics/tangent.hpp"

namespace sundrape {
namespace {

constexpr double cautious = 0.2;   // of the largest move: without a prediction, and for obstacles
constexpr double lagging = 0.5;    // a prediction of less than this part of the supports' way: they start from rest
constexpr int most_halvings = 20;  // of a prediction that leads through cloth
constexpr int looks = 32;          // at places on the way of a step, which may lead there and back

/// Largest way of `far` from the beginning of a step to any time in it [m].
template <class Way>
double furthest(double from, double to, Way&& way) {
  double most = 0;
  for (int k = 1; k <= looks; ++k) most = std::max(most, way(from + k * (to - from) / looks));
  return most;
}

/// Largest coordinate by which supports move between two times [m].
double way_of_supports(const System& system, const Vector& q, double from, double to) {
  Vector now = q, then = q;
  system.carry(from, statics_by_time, now);
  system.carry(to, statics_by_time, then);
  return (then - now).cwiseAbs().maxCoeff();
}

/// The step from a time, at most `step`, halved until nothing goes too far in it [s].
double shortened(const System& system, const FollowOptions& options, const Vector& q, double from, double step,
                 double reach) {
  const double least = 1e-9 * step;
  const auto too_far = [&](double to) {
    if (furthest(from, to, [&](double t) { return way_of_supports(system, q, from, t); }) > reach) return true;
    return options.way_of_obstacles && furthest(from, to, [&](double t) {
                                         return options.way_of_obstacles(q, from, t);
                                       }) > cautious * options.relaxation.largest_move;
  };
  while (step > least && too_far(from + step)) step *= 0.5;
  return step;
}

/// Whether cloth that goes from one shape to another passes through cloth.
bool passes_through(const System& system, const Vector& from, const Vector& to, double time) {
  if (!system.watches_passages()) return false;
  const Vector still = Vector::Zero(from.size());
  return system.passage({time, from, still, statics_by_time}, {time, to, still, statics_by_time}).has_value();
}

/// Work of supports and obstacles that go from one place to another while the free points rest: their forces at one
/// end times the way [J].
double work_over(const System& system, const Vector& q, double time, double from, double to) {
  const Vector still = Vector::Zero(q.size());
  Vector f(q.size()), start = q, end = q;
  system.force({time, q, still, statics_by_time}, f);
  system.carry(from, statics_by_time, start);
  system.carry(to, statics_by_time, end);
  return -system.unknowns().held_dot(f, end - start);
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
    double step = shortened(system, options, q, result.time, remaining, largest_move);
    rate.setZero();
    const bool solved = tangent.factor(equations.state(q, result.time)) == FactorStatus::ok &&
                        tangent.negative_pivots() == 0 &&
                        tangent.solve(equations.load_direction(q, result.time), rate).ok && rate.allFinite();
    const double fastest = rate.cwiseAbs().maxCoeff();
    if (solved && fastest * step >= lagging * way_of_supports(system, q, result.time, result.time + step))
      step = std::min(step, largest_move / fastest);
    else {
      rate.setZero();
      step = shortened(system, options, q, result.time, step, cautious * largest_move);
    }
    Vector tried = q;
    const auto goal = [&] { return step == remaining ? to : result.time + step; };  // rounding must not miss the end
    const auto predict = [&] {
      tried = q;
      equations.move(tried, step * rate, goal());
    };
    predict();
    for (int halvings = 0; halvings < most_halvings && passes_through(system, q, tried, result.time); ++halvings) {
      step *= 0.5;
      predict();
    }

    auto relaxation = options.relaxation;
    relaxation.load_factor = goal();
    relaxation.stage = statics_by_time;
    if (goal() < to) relaxation.tolerance = std::max(options.loose_tolerance, relaxation.tolerance);
    const auto found = relax(system, solver, relaxation, tried, observer);
    result.relaxation = after(result.relaxation, found);
    ++result.relaxation.factorizations;  // of the prediction
    if (found.end != RelaxationEnd::converged) return result;
    result.work += 0.5 * (work_over(system, q, result.time, result.time, relaxation.load_factor) +
                          work_over(system, tried, relaxation.load_factor, result.time, relaxation.load_factor));
    q = tried;
    result.time = relaxation.load_factor;
  }
  return result;
}

}  // namespace sundrape

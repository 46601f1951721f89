#include "stage_follower.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sundrape/statics/stable_neighbour.hpp"

#include "branch_switch.hpp"

namespace sundrape {
namespace {

constexpr int most_halvings = 30;
constexpr int most_short_steps =
    10;  // below a tenth of the first increment, before cloth is taken to have come to an end
constexpr int halvings_for_a_kink = 4;  // that far a step is halved because it turns off its prediction
constexpr double same_load = 1e-9;      // load factors closer than this are one
constexpr double least_cosine =
    0.5;  // between a step and its prediction: one that turns further may have left the path
constexpr double farthest =
    3;                      // times its prediction that a step may move: one to a limit point of the load moves twice
constexpr int erratic = 5;  // rises of the residual in one step: as the article tells its buckling mode (table 1)
constexpr double largest_load = 100;  // a path that gets so far beyond its full load will not come back

}  // namespace

StageFollower::StageFollower(const System& system, Tangent& tangent, const PathOptions& options, PathPosition& at,
                             PathObserver& observer)
    : system_(system),
      options_(options),
      at_(at),
      observer_(observer),
      solver_{StagedEquilibrium(system, at.stage, at.q, options.force_scale), tangent, options, system},
      first_increment_(
          options.first_increment[std::min(static_cast<std::size_t>(at.stage), options.first_increment.size()) - 1]),
      counted_factorizations_(tangent.factorizations()) {}

PathResult StageFollower::run() {
  if (at_.arc_length == 0 && at_.load_factor == 0) {
    if (auto failure = begin()) return *failure;
  } else if (options_.fall && assess() && pivots_.value_or(0) > 0) {  // stopped before it had fallen
    if (auto failure = fall(at_.load_factor)) return *failure;
  }
  while (at_.load_factor < 1 - same_load) {
    if (observer_.wants_to_stop()) return {PathEnd::stopped, ""};
    if (at_.steps >= options_.max_steps)
      return stall(fmt::format("the path has not come to the full load in {} steps", at_.steps),
                   "raise arc-length.max_steps, or look at the load-displacement curve: the load may never get there");
    if (std::abs(at_.load_factor) > largest_load)
      return stall("the path has left the range of its loads", "nothing seems to resist them: look at the supports");
    if (auto failure = step()) return *failure;
  }
  return {};
}

StageFollower::Failure StageFollower::begin() {
  const double residual =
      solver_.equations.out_of_balance(at_.q, 0).norm() / solver_.equations.force_scale(at_.q, first_increment_);
  if (residual <= options_.tolerance) {
    assess();
    return {};
  }
  PathPoint to{at_.q, first_increment_};
  system_.carry(first_increment_, at_.stage, to.q);
  const auto found = correct_at_load(solver_, to, report());
  at_.iterations += found.iterations;
  if (!found.converged)
    return stall(fmt::format("no equilibrium under the first increment of {:.3g} (residual {:.3g})", first_increment_,
                             found.residual),
                 "the cloth does not rest where it starts: try a smaller arc-length.first_load_increment, or "
                 "analysis = \"relaxation\"");
  accept(to, found, 0, 0);
  begin_anew();  // coming to rest was no step along the path
  return {};
}

StageFollower::Failure StageFollower::step() {
  if (!assessed_ && !assess())
    return stall("the tangent stiffness is singular",
                 "hold what can move freely, or start from a smaller first_load_increment so that the cloth stiffens "
                 "before it moves far");
  if (at_.arc_length == 0 && solver_.tangent.neutral_part(by_load_) > 0.5) {
    if (options_.fall) return fall_further(0);
    return stall("the tangent stiffness is singular: nothing resists the motion that the load begins",
                 "hold what can move freely; where the cloth swings down first, start from where it hangs (cloth.start "
                 "= the result of a relaxation), or take arc-length.when_unstable = \"fall\"");
  }
  const double norm = std::sqrt(solver_.dot(by_load_, 1, by_load_, 1));
  const bool first = at_.arc_length == 0;
  // a stable path leads to more load; where it ends, cloth falls, and load steps find what they find
  const bool onwards = options_.fall || options_.control == PathControl::load;
  const double sense = forward_ || onwards ? 1 : -1;
  double length = predicted_length(norm);
  const double intended = length / norm;
  // under load control forces that differ by less than the tolerance are the same
  const double least = options_.control == PathControl::load ? options_.tolerance * norm : 0;
  for (int halvings = 0; halvings <= most_halvings && length > least; ++halvings, length /= 2) {
    double load = sense * length / norm;
    if (at_.load_factor + load > 1) load = 1 - at_.load_factor;  // not further than the full load
    PathPoint to = here();
    to.load_factor += load;
    solver_.equations.move(to.q, load * by_load_, to.load_factor);
    Correction found = correct(to, std::abs(load) * norm);
    at_.iterations += found.iterations;
    if (found.converged && to.load_factor > 1 + same_load) found = back_to_full_load(to);
    // where a contact closes the path has a kink, which no shorter step avoids
    if (found.converged && !first && halvings < halvings_for_a_kink && strays(to, sense)) found.converged = false;
    if (found.converged && passes(to)) found.converged = false;
    if (found.converged && options_.fall && to.load_factor <= at_.load_factor) found.converged = false;
    if (found.converged) {
      const double predicted = std::abs(load) * by_load_.cwiseAbs().maxCoeff();
      accept(to, found, halvings, std::abs(load) * norm);
      if (first || options_.control == PathControl::load) doubt(found, predicted, first);
      return after_step();
    }
    if (observer_.wants_to_stop()) return PathResult{PathEnd::stopped, ""};
    if (options_.fall && halvings == halvings_for_a_kink - 1) return fall_further(intended);
  }
  return stall(fmt::format("no equilibrium found near by, down to increments of {:.2g}", length / norm),
               options_.control == PathControl::load
                   ? "the load may be at a limit: use arc-length.control = \"arc-length\""
                   : "two branches may be very close, or a contact may open and close: try another "
                     "first_load_increment, a wavier sheet (cloth.waviness), or analysis = \"relaxation\"");
}

bool StageFollower::assess() {
  if (solver_.tangent.factor(solver_.equations.state(at_.q, at_.load_factor)) != FactorStatus::ok) return false;
  pivots_ = solver_.tangent.negative_pivots();
  const Vector load_direction = solver_.equations.load_direction(at_.q, at_.load_factor);
  by_load_.resize(load_direction.size());
  if (!solver_.tangent.solve(load_direction, by_load_).ok) return false;
  // at the start of a stage the last step is zero: towards more load
  forward_ = solver_.dot(solver_.rows(at_.step_q), at_.step_load, by_load_, 1) >= 0;
  assessed_ = true;
  return true;
}

double StageFollower::predicted_length(double norm) const {
  if (at_.arc_length == 0) return first_increment_ * norm;
  const double factor =
      options_.accelerate ? options_.target_iterations / std::max(1.0, static_cast<double>(at_.step_iterations)) : 1;
  const double last = options_.control == PathControl::load ? std::abs(at_.step_load) * norm : at_.arc_length;
  if (options_.largest_move <= 0) return factor * last;
  const double move = by_load_.cwiseAbs().maxCoeff() / norm;  // of a node per length
  return std::min(factor * last, options_.largest_move / move);
}

Correction StageFollower::correct(PathPoint& to, double length) {
  const bool at_full_load = std::abs(to.load_factor - 1) <= same_load;
  if (options_.control == PathControl::load || at_full_load) return correct_at_load(solver_, to, report());
  return correct_on_arc(solver_, here(), length, to, report());
}

Correction StageFollower::back_to_full_load(PathPoint& to) {
  const double share = (1 - at_.load_factor) / (to.load_factor - at_.load_factor);
  const Vector way = solver_.rows(to.q) - solver_.rows(at_.q);
  to = here();
  to.load_factor = 1;
  solver_.equations.move(to.q, share * way, 1);
  const auto found = correct_at_load(solver_, to, report());
  at_.iterations += found.iterations;
  return found;
}

bool StageFollower::passes(const PathPoint& to) const {
  return system_.passage(solver_.equations.state(at_.q, at_.load_factor), solver_.equations.state(to.q, to.load_factor))
      .has_value();
}

bool StageFollower::strays(const PathPoint& to, double sense) const {
  const Vector way = solver_.rows(to.q) - solver_.rows(at_.q);
  const double load = to.load_factor - at_.load_factor;
  const double lengths = std::sqrt(solver_.dot(way, load, way, load) * solver_.dot(by_load_, 1, by_load_, 1));
  return sense * solver_.dot(way, load, by_load_, 1) < least_cosine * lengths;
}

void StageFollower::accept(const PathPoint& to, const Correction& found, int halvings, double length) {
  before_ = pivots_ ? std::optional(AssessedPoint{here(), *pivots_}) : std::nullopt;
  was_forward_ = forward_;
  at_.step_q = to.q - at_.q;
  at_.step_load = to.load_factor - at_.load_factor;
  const Vector way = solver_.rows(at_.step_q);
  at_.arc_length = length > 0 ? length : std::sqrt(solver_.dot(way, at_.step_load, way, at_.step_load));
  at_.step_iterations = found.iterations;
  at_.q = to.q;
  at_.load_factor = std::abs(to.load_factor - 1) <= same_load ? 1 : to.load_factor;
  ++at_.steps;
  assessed_ = false;
  const bool known = assess();
  count_factorizations();
  observer_.step(at_, {.iterations = found.iterations,
                       .halvings = halvings,
                       .residual = found.residual,
                       .negative_pivots = known ? pivots_ : std::nullopt});
}

StageFollower::Failure StageFollower::after_step() {
  if (auto failure = meet_critical_points()) return failure;
  if (!options_.fall) return {};
  if (pivots_.value_or(0) > 0) return fall(at_.load_factor);
  short_steps_ = std::abs(at_.step_load) < 0.1 * first_increment_ ? short_steps_ + 1 : 0;
  return short_steps_ >= most_short_steps ? fall_further(0) : Failure{};
}

StageFollower::Failure StageFollower::meet_critical_points() {
  if (!pivots_ || !before_ || *pivots_ == before_->negative_pivots) return {};
  const AssessedPoint after{here(), *pivots_};
  Failure end;
  const auto met = [&](const CriticalPoint& point) {
    observer_.critical_point(point);
    if (point.kind != CriticalPoint::Kind::bifurcation) return true;
    ++at_.bifurcations;
    if (options_.at_bifurcation == AtBifurcation::pass || at_.bifurcations != options_.branch) return true;
    if (options_.at_bifurcation == AtBifurcation::stop)
      end = PathResult{PathEnd::at_bifurcation, ""};
    else
      end = switch_branch(point);
    return false;
  };
  const auto unexplained = each_critical_point(solver_, *before_, after, forward_ != was_forward_, met);
  if (unexplained)
    observer_.warn(fmt::format(
        "negative pivots change from {} to {} between load factors {:.6g} and {:.6g} of stage {}, but no "
        "path between these was found: the step may have jumped to another branch; smaller steps "
        "(first_load_increment, largest_move) tell",
        unexplained->negative_pivots, after.negative_pivots, unexplained->at.load_factor, at_.load_factor, at_.stage));
  count_factorizations();
  return end;
}

StageFollower::Failure StageFollower::switch_branch(const CriticalPoint& bifurcation) {
  const auto start = start_on_branch(solver_, bifurcation);
  at_.iterations += start.iterations;
  at_.q = bifurcation.q;
  at_.load_factor = bifurcation.load_factor;
  if (!start.found.converged)
    return stall("no equilibrium was found on the branch along the mode of a bifurcation",
                 "try another arc-length.branch_amplitude, or its negative");
  pivots_.reset();
  accept(start.at, start.found, start.halvings, 0);
  observer_.remark(fmt::format("left the path along the mode of the bifurcation at load factor {:.6g} of stage {}",
                               bifurcation.load_factor, bifurcation.stage));
  return {};
}

StageFollower::Failure StageFollower::fall(double load_factor) {
  UnseenRelaxation unseen([this] { return observer_.wants_to_stop(); });
  const auto direct = make_linear_solver(system_.has_symmetric_tangent() ? SolverKind::cholesky : SolverKind::lu);
  auto relaxation = options_.relaxation;
  relaxation.stage = at_.stage;
  relaxation.load_factor = load_factor;
  PathPoint to{at_.q, load_factor};
  system_.carry(load_factor, at_.stage, to.q);
  const int unstable = pivots_.value_or(0);
  const auto found =
      relax_until_stable(system_, *direct, relaxation, options_.push, options_.neutral_frequency, to.q, unseen).result;
  at_.factorizations += found.factorizations;
  if (found.end == RelaxationEnd::stopped) return PathResult{PathEnd::stopped, ""};
  if (found.end != RelaxationEnd::converged)
    return stall("no stable equilibrium was found after the path lost its stability (" + found.diagnosis + ")",
                 "arc-length.when_unstable = \"follow\" goes on along the unstable path");
  const double furthest = (to.q - at_.q).cwiseAbs().maxCoeff();
  accept(to, {true, found.iterations, found.residual}, 0, 0);
  observer_.remark(fmt::format(
      "no stable path further: at load factor {:.6g} of stage {} fell by up to {:.3g} mm, {} -> {} negative pivots",
      at_.load_factor, at_.stage, 1e3 * furthest, unstable, pivots_.value_or(-1)));
  begin_anew();
  return {};
}

StageFollower::Failure StageFollower::fall_further(double increment) {
  fall_increment_ = std::max({increment, first_increment_, 2 * fall_increment_});  // one fall may follow another
  short_steps_ = 0;
  return fall(std::min(1.0, at_.load_factor + fall_increment_));
}

void StageFollower::doubt(const Correction& found, double predicted, bool first) {
  const double moved = at_.step_q.cwiseAbs().maxCoeff();
  const bool far = moved > farthest * predicted;
  if (!far && found.rises < erratic) return;
  const auto sign = far ? fmt::format("moved by up to {:.3g} mm, of {:.3g} mm predicted", 1e3 * moved, 1e3 * predicted)
                        : fmt::format("converged erratically: its residual rose in {} of {} iterations", found.rises,
                                      found.iterations);
  observer_.warn(
      fmt::format("the {}step to load factor {:.6g} of stage {} {}; it may have left the path for another "
                  "branch: {}",
                  first ? "first " : "", at_.load_factor, at_.stage, sign,
                  first ? "a smaller arc-length.first_load_increment tells"
                        : "arc-length.control = \"arc-length\" follows the path past limits of the load"));
}

void StageFollower::begin_anew() {
  at_.step_q.setZero();
  at_.step_load = at_.arc_length = 0;
  forward_ = true;
}

void StageFollower::count_factorizations() {
  at_.factorizations += solver_.tangent.factorizations() - counted_factorizations_;
  counted_factorizations_ = solver_.tangent.factorizations();
}

PathResult StageFollower::stall(const std::string& what, const std::string& advice) const {
  return {PathEnd::stalled, fmt::format("{} at load factor {:.6g} of stage {}, after {} steps; {}", what,
                                        at_.load_factor, at_.stage, at_.steps, advice)};
}

ResidualReport StageFollower::report() {
  return [this](int iteration, double load_factor, double residual) {
    observer_.iteration(at_, iteration, load_factor, residual);
  };
}

}  // namespace sundrape

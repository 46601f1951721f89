#include "sundrape/statics/equilibrium_path.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sundrape/statics/stable_neighbour.hpp"

#include "critical_point.hpp"

namespace sundrape {
namespace {

constexpr int most_cuts = 30;
constexpr int most_short_steps =
    10;  // below a tenth of the first increment, before cloth is taken to have come to an end
constexpr int cuts_for_a_kink = 4;  // that far a step is halved because it turns off its prediction
constexpr double same_load = 1e-9;  // load factors closer than this are one
constexpr double least_cosine =
    0.5;  // between a step and its prediction: one that turns further may have left the path
constexpr double largest_load = 100;  // a path that gets so far beyond its full load will not come back

/// Follows the path through one stage.
class StageFollower {
 public:
  StageFollower(const System& system, Tangent& tangent, const PathOptions& options, PathPosition& at,
                PathObserver& observer)
      : system_(system),
        options_(options),
        at_(at),
        observer_(observer),
        solver_{StagedEquilibrium(system, at.stage, at.q, options.force_scale), tangent, options, system},
        first_increment_(
            options.first_increment[std::min(static_cast<std::size_t>(at.stage), options.first_increment.size()) - 1]) {
  }

  PathResult run() {
    if (at_.arc_length == 0 && at_.load_factor == 0)
      if (auto failure = begin()) return *failure;
    while (at_.load_factor < 1 - same_load) {
      if (observer_.wants_to_stop()) return {PathEnd::stopped, ""};
      if (at_.steps >= options_.max_steps)
        return stall(
            fmt::format("the path has not come to the full load in {} steps", at_.steps),
            "raise arc-length.max_steps, or look at the load-displacement curve: the load may never get there");
      if (std::abs(at_.load_factor) > largest_load)
        return stall("the path has left the range of its loads", "nothing seems to resist them: look at the supports");
      if (auto failure = step()) return *failure;
    }
    return {};
  }

 private:
  using Failure = std::optional<PathResult>;

  PathResult stall(const std::string& what, const std::string& advice) {
    return {PathEnd::stalled, fmt::format("{} at load factor {:.6g} of stage {}, after {} steps; {}", what,
                                          at_.load_factor, at_.stage, at_.steps, advice)};
  }
  [[nodiscard]] PathPoint here() const { return {at_.q, at_.load_factor}; }
  [[nodiscard]] ResidualReport report() {
    return [this](int iteration, double load_factor, double residual) {
      observer_.iteration(at_, iteration, load_factor, residual);
    };
  }

  /// Where forces do not balance without load (cloth that lies on an obstacle), the first increment is put on at once.
  Failure begin() {
    const double residual =
        solver_.equations.out_of_balance(at_.q, 0).norm() / solver_.equations.force_scale(at_.q, first_increment_);
    if (residual <= options_.tolerance) {
      judge();
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
    // coming to rest was no step along the path: the next one is the stage's first
    at_.step_q.setZero();
    at_.step_load = at_.arc_length = 0;
    forward_ = true;
    return {};
  }

  /// Factors the tangent here and keeps what it says.
  bool judge() {
    if (solver_.tangent.factor(solver_.equations.state(at_.q, at_.load_factor)) != FactorStatus::ok) return false;
    pivots_ = solver_.tangent.negative_pivots();
    load_direction_ = solver_.equations.load_direction(at_.q, at_.load_factor);
    by_load_.resize(load_direction_.size());
    if (!solver_.tangent.solve(load_direction_, by_load_).ok) return false;
    const Vector last = solver_.rows(at_.step_q);
    forward_ = solver_.dot(last, at_.step_load, by_load_, 1) >= 0;  // at the start of a stage: towards more load
    judged_ = true;
    return true;
  }

  Failure step() {
    if (!judged_ && !judge())
      return stall("the tangent stiffness is singular",
                   "hold what can move freely, or start from a smaller first_load_increment so that the cloth stiffens "
                   "before it moves far");
    const double norm = std::sqrt(solver_.dot(by_load_, 1, by_load_, 1));
    const bool first = at_.arc_length == 0;
    double length = first_increment_ * norm;
    if (!first) {
      const double factor = options_.accelerate
                                ? options_.target_iterations / std::max(1.0, static_cast<double>(at_.step_iterations))
                                : 1;
      length =
          factor * (options_.control == PathControl::load ? std::abs(at_.step_load) * norm : at_.arc_length);  // (20)
    }
    const double move = by_load_.cwiseAbs().maxCoeff() / norm;  // of a node per length
    if (!first && options_.largest_move > 0) length = std::min(length, options_.largest_move / move);
    // a stable path leads to more load; where it ends, cloth falls
    const double sense = forward_ || options_.fall ? 1 : -1;
    const double intended = length / norm;
    int spent = 0;
    for (int cuts = 0; cuts <= most_cuts; ++cuts, length /= 2) {
      double load = sense * length / norm;
      if (at_.load_factor + load > 1) load = 1 - at_.load_factor;  // not further than the full load
      PathPoint to = here();
      to.load_factor += load;
      solver_.equations.move(to.q, load * by_load_, to.load_factor);
      Correction found = correct(to, std::abs(load) * norm);
      spent += found.iterations;
      if (found.converged && to.load_factor > 1 + same_load) found = back_to_full_load(to);
      // where a contact closes the path has a kink, which no shorter step avoids
      if (found.converged && !first && cuts < cuts_for_a_kink && strays(to, sense)) found.converged = false;
      if (found.converged && options_.fall && to.load_factor <= at_.load_factor) found.converged = false;
      if (found.converged) {
        at_.iterations += spent;
        accept(to, found, cuts, std::abs(load) * norm);
        if (auto failure = after_step()) return failure;
        if (!options_.fall) return {};
        if (pivots_.value_or(0) > 0) return fall(at_.load_factor);
        short_steps_ = std::abs(at_.step_load) < 0.1 * first_increment_ ? short_steps_ + 1 : 0;
        return short_steps_ >= most_short_steps ? fall_further(0) : Failure{};
      }
      if (observer_.wants_to_stop()) return PathResult{PathEnd::stopped, ""};
      if (options_.fall && cuts == cuts_for_a_kink - 1) {
        at_.iterations += spent;
        return fall_further(intended);
      }
      judged_ = false;
      if (!judge()) break;
    }
    at_.iterations += spent;
    return stall(fmt::format("no equilibrium found near by, down to increments of {:.2g}", length / norm),
                 options_.control == PathControl::load
                     ? "the load may be at a limit: use arc-length.control = \"arc-length\""
                     : "two branches may be very close, or a contact may open and close: try another "
                       "first_load_increment, a wavier sheet (cloth.waviness), or analysis = \"relaxation\"");
  }

  Correction correct(PathPoint& to, double length) {
    const bool at_full_load = std::abs(to.load_factor - 1) <= same_load;
    if (options_.control == PathControl::load || at_full_load) return correct_at_load(solver_, to, report());
    return correct_on_arc(solver_, here(), length, to, report());
  }

  /// From an equilibrium beyond the full load to one under it.
  Correction back_to_full_load(PathPoint& to) {
    const double share = (1 - at_.load_factor) / (to.load_factor - at_.load_factor);
    const Vector way = solver_.rows(to.q) - solver_.rows(at_.q);
    to = here();
    to.load_factor = 1;
    solver_.equations.move(to.q, share * way, 1);
    return correct_at_load(solver_, to, report());
  }

  /// Whether a step has gone another way than predicted.
  [[nodiscard]] bool strays(const PathPoint& to, double sense) const {
    const Vector way = solver_.rows(to.q) - solver_.rows(at_.q);
    const double load = to.load_factor - at_.load_factor;
    const double lengths = std::sqrt(solver_.dot(way, load, way, load) * solver_.dot(by_load_, 1, by_load_, 1));
    return sense * solver_.dot(way, load, by_load_, 1) < least_cosine * lengths;
  }

  void accept(const PathPoint& to, const Correction& found, int cuts, double length) {
    before_ = JudgedPoint{here(), pivots_.value_or(-1)};
    was_forward_ = forward_;
    at_.step_q = to.q - at_.q;
    at_.step_load = to.load_factor - at_.load_factor;
    const Vector way = solver_.rows(at_.step_q);
    at_.arc_length = length > 0 ? length : std::sqrt(solver_.dot(way, at_.step_load, way, at_.step_load));
    at_.step_iterations = found.iterations;
    at_.q = to.q;
    at_.load_factor = std::abs(to.load_factor - 1) <= same_load ? 1 : to.load_factor;
    ++at_.steps;
    judged_ = false;
    const bool known = judge();
    at_.factorizations = solver_.tangent.factorizations();
    observer_.step(at_, {.iterations = found.iterations,
                         .cuts = cuts,
                         .arc_length = at_.arc_length,
                         .residual = found.residual,
                         .negative_pivots = known ? pivots_ : std::nullopt});
  }

  /// Critical points that the last step has passed.
  Failure after_step() {
    if (!options_.locate || !pivots_ || before_.negative_pivots < 0 || *pivots_ == before_.negative_pivots) return {};
    const int after = *pivots_;
    const bool limit_point = forward_ != was_forward_;
    JudgedPoint from = before_;
    for (int k = 0; k < 6 && from.negative_pivots != after; ++k) {
      const auto found = locate_critical_point(solver_, from, {here(), after}, limit_point && k == 0);
      if (!found) {
        observer_.remark(fmt::format(
            "negative pivots change from {} to {} between load factors {:.6g} and {:.6g} of stage {}, but no path "
            "between "
            "these was found: the step may have jumped to another branch; smaller steps (first_load_increment, "
            "largest_move) tell",
            from.negative_pivots, after, from.at.load_factor, at_.load_factor, at_.stage));
        break;
      }
      observer_.critical_point(*found);
      if (found->kind == CriticalPoint::Kind::bifurcation) {
        ++at_.forks;
        if (options_.at_bifurcation != AtBifurcation::pass && at_.forks == options_.branch) {
          if (options_.at_bifurcation == AtBifurcation::stop) {
            judged_ = false;
            return PathResult{PathEnd::at_bifurcation, ""};
          }
          return switch_branch(*found);
        }
      }
      if (found->pivots_after == from.negative_pivots) break;
      from = {{found->q, found->load_factor}, found->pivots_after};
    }
    judged_ = false;
    (void)judge();
    at_.factorizations = solver_.tangent.factorizations();
    return {};
  }

  /// The same under more load than here, where the path creeps or ends.
  Failure fall_further(double increment) {
    fall_increment_ = std::max({increment, first_increment_, 2 * fall_increment_});  // one fall may follow another
    short_steps_ = 0;
    return fall(std::min(1.0, at_.load_factor + fall_increment_));
  }

  /// To the stable equilibrium that cloth goes to under a load when it has lost its stability, or its path has ended.
  Failure fall(double load_factor) {
    struct Quiet final : RelaxationObserver {
      explicit Quiet(PathObserver& path) : path_(path) {}
      void step(const State& /*all*/, const RelaxationStep& /*step*/) override {}
      [[nodiscard]] bool wants_to_stop() override { return path_.wants_to_stop(); }
      PathObserver& path_;
    } quiet(observer_);
    const auto direct = make_linear_solver(system_.has_symmetric_tangent() ? SolverKind::cholesky : SolverKind::lu);
    auto relaxation = options_.relaxation;
    relaxation.stage = at_.stage;
    relaxation.load_factor = load_factor;
    Vector fallen = at_.q;
    system_.carry(load_factor, at_.stage, fallen);
    const int unstable = pivots_.value_or(0);
    StableNeighbour found{relax(system_, *direct, relaxation, fallen, quiet), {}};
    if (found.result.end == RelaxationEnd::converged) {
      const int iterations = found.result.iterations;
      found = relax_to_stable_neighbour(system_, *direct, relaxation, options_.push, options_.neutral_frequency, fallen,
                                        quiet);
      found.result.iterations += iterations;
    }
    if (found.result.end == RelaxationEnd::stopped) return PathResult{PathEnd::stopped, ""};
    if (found.result.end != RelaxationEnd::converged)
      return stall("no stable equilibrium was found after the path lost its stability (" + found.result.diagnosis + ")",
                   "arc-length.when_unstable = \"follow\" goes on along the unstable path");
    const double furthest = (fallen - at_.q).cwiseAbs().maxCoeff();
    at_.factorizations += found.result.factorizations;
    accept({fallen, load_factor}, {true, found.result.iterations, found.result.residual}, 0, 0);
    observer_.remark(fmt::format(
        "no stable path further: at load factor {:.6g} of stage {} fell by up to {:.3g} mm, {} -> {} negative pivots",
        at_.load_factor, at_.stage, 1e3 * furthest, unstable, pivots_.value_or(-1)));
    // a fall is no step along the path: from here it begins anew, towards more load
    at_.step_q.setZero();
    at_.step_load = at_.arc_length = 0;
    forward_ = true;
    return {};
  }

  /// Onto the branch that leaves a fork along its mode (Wagner and Wriggers 1988): a move along the mode, corrected in
  /// the plane normal to it.
  Failure switch_branch(const CriticalPoint& fork) {
    at_.q = fork.q;
    at_.load_factor = fork.load_factor;
    const Vector along = solver_.rows(fork.mode);
    double amplitude = options_.branch_amplitude;
    for (int cuts = 0; cuts < 8; ++cuts, amplitude /= 2) {
      PathPoint to = here();
      solver_.equations.move(to.q, amplitude * along, to.load_factor);
      const auto found = correct_on_plane(solver_, along, 0, to);
      at_.iterations += found.iterations;
      if (!found.converged) continue;
      pivots_.reset();
      at_.step_iterations = options_.target_iterations;
      accept(to, found, cuts, 0);
      observer_.remark(fmt::format("left the path along the mode of the fork at load factor {:.6g} of stage {}",
                                   fork.load_factor, fork.stage));
      return {};
    }
    return stall("no equilibrium was found on the branch along the mode of a fork",
                 "try another arc-length.branch_amplitude, or its negative");
  }

  const System& system_;
  const PathOptions& options_;
  PathPosition& at_;
  PathObserver& observer_;
  StageSolver solver_;
  double first_increment_, fall_increment_ = 0;  // of the load factor
  int short_steps_ = 0;                          // in a row, while falling is allowed
  Vector by_load_, load_direction_;              // u^I and F_0 here, rows
  std::optional<int> pivots_;                    // here
  bool judged_ = false, forward_ = true, was_forward_ = true;
  JudgedPoint before_;
};

}  // namespace

PathResult follow_path(const System& system, const PathOptions& options, PathPosition& at, PathObserver& observer) {
  Tangent tangent(system, options.neutral_frequency);
  if (at.step_q.size() != at.q.size()) at.step_q = Vector::Zero(at.q.size());
  for (; at.stage <= options.stages; ++at.stage) {
    const auto result = StageFollower(system, tangent, options, at, observer).run();
    if (result.end != PathEnd::complete || at.stage == options.stages) return result;
    at.load_factor = 0;
    at.arc_length = at.step_load = 0;
    at.step_q.setZero();
  }
  return {};
}

}  // namespace sundrape

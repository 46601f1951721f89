#include <cmath>

#include <fmt/format.h>

#include "sundrape/app/analyses.hpp"
#include "sundrape/app/mishaps.hpp"
#include "sundrape/app/solver_choice.hpp"
#include "sundrape/app/stop_request.hpp"
#include "sundrape/statics/equilibrium_path.hpp"
#include "sundrape/statics/stable_neighbour.hpp"

namespace sundrape {
namespace {

/// What the supports and the loads without gravity do on the way from one equilibrium to the next, by the mean of their
/// forces at both.
double work_between(const System& system, const State& before, const State& after) {
  const Vector way = after.q - before.q;
  double work = 0;
  for (const auto& all : {before, after}) {
    Vector loads = Vector::Zero(way.size()), forces = loads;
    for (const auto& term : system.terms())
      if (term->is_external() && term->kind() != EnergyKind::gravity) term->add_force(all, loads);
    system.force(all, forces);
    work += 0.5 * (loads.dot(way) - system.unknowns().held_dot(forces, way));
  }
  return work;
}

constexpr int most_kept_warnings = 10;  // of a path's, in the result

std::string critical_text(const CriticalPoint& point) {
  const bool limit = point.kind == CriticalPoint::Kind::limit_point;
  return fmt::format("{} at load factor {:.6g} ± {:.1g} of stage {}: {} -> {} negative pivots",
                     limit ? "limit point" : "bifurcation", point.load_factor, point.uncertainty, point.stage,
                     point.pivots_before, point.pivots_after);
}

class Watch final : public PathObserver {
 public:
  Watch(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress)
      : case_(c),
        model_(model),
        recorder_(recorder),
        progress_(progress),
        still_(Vector::Zero(model.initial.size())),
        mishaps_(c, model),
        stop_(c.arc_length.time_limit) {
    if (const auto& restart = recorder.restart()) work_ = restart->balance.external_work;
  }

  void step(const PathPosition& at, const PathStep& step) override {
    const State now{at.load_factor, at.q, still_, at.stage};
    if (before_.size() == at.q.size())
      work_ += work_between(*model_.system, {before_load_, before_, still_, at.stage}, now);
    before_ = at.q;
    before_load_ = at.load_factor == 1 ? 0 : at.load_factor;  // the next stage begins where this one ends
    last_ = step;
    mishap_ = mishaps_.at(now);
    const auto contact = recorder_.step({at.load_factor, at.q, still_, at.stage});
    recorder_.step_values({{"load_factor", at.load_factor},
                           {"stage", at.stage},
                           {"arc_length", at.arc_length},
                           {"newton_iterations", step.iterations},
                           {"halvings", step.halvings},
                           {"residual", step.residual},
                           {"contacts", contact.contacts},
                           {"negative_pivots", step.negative_pivots.value_or(-1)}});
    if (at.load_factor == 1 || at.steps % case_.arc_length.frame_every == 0) {
      frame(at);
      checkpoint(at);
    }
    if (progress_.due())
      progress_.show(fmt::format("stage {} of {}, step {}: load factor {:.5g}, {} iterations, {} contacts, {} negative "
                                 "pivots",
                                 at.stage, case_.stages(), at.steps, at.load_factor, step.iterations, contact.contacts,
                                 step.negative_pivots.value_or(-1)),
                     (at.stage - 1 + std::max(0.0, at.load_factor)) / case_.stages());
  }

  void iteration(const PathPosition& from, int iteration, double load_factor, double residual) override {
    const auto step = static_cast<int>(from.steps) + 1;
    recorder_.iteration({.step = step, .iteration = iteration, .load_factor = load_factor, .residual = residual});
    if (from.steps == 0)
      progress_.remark(fmt::format("step {} iteration {:2}  load factor {:.8e}  residual {:.8e}", step, iteration,
                                   load_factor, residual));
  }

  void critical_point(const CriticalPoint& point) override {
    ++critical_points_;
    progress_.say(critical_text(point));
    recorder_.critical_point({.limit_point = point.kind == CriticalPoint::Kind::limit_point,
                              .stage = point.stage,
                              .load_factor = point.load_factor,
                              .uncertainty = point.uncertainty,
                              .pivots_before = point.pivots_before,
                              .pivots_after = point.pivots_after,
                              .position = model_.of_nodes(point.q),
                              .mode = model_.of_nodes(point.mode)});
  }

  void remark(const std::string& text) override { progress_.say(text); }
  void warn(const std::string& text) override {
    progress_.say("warning: " + text);
    if (++warnings_ <= most_kept_warnings) recorder_.warn(text);
  }
  [[nodiscard]] bool wants_to_stop() override { return mishap_ || stop_.wanted(); }
  [[nodiscard]] const std::optional<std::string>& mishap() const { return mishap_; }
  [[nodiscard]] bool out_of_time() const { return stop_.out_of_time(); }
  [[nodiscard]] int critical_points() const { return critical_points_; }
  [[nodiscard]] const PathStep& last() const { return last_; }

  void frame(const PathPosition& at) {
    recorder_.frame({at.load_factor, at.q, still_, at.stage}, balance(at), last_.negative_pivots, last_.residual);
    framed_ = at.steps;
  }
  /// Whether this position has no frame yet.
  [[nodiscard]] bool is_new(const PathPosition& at) const { return framed_ != at.steps; }
  void start_from(const PathPosition& at) {
    before_ = at.q;
    before_load_ = at.load_factor;
    framed_ = at.steps;
  }
  /// The state that the end of the path was relaxed to.
  void frame(const PathPosition& at, const PathStep& step) {
    last_ = step;
    frame(at);
  }

  void checkpoint(const PathPosition& at) {
    recorder_.checkpoint(
        {at.load_factor, at.q, at.step_q, at.stage}, balance(at), 0, at.arc_length,
        {static_cast<double>(at.stage), at.step_load, static_cast<double>(at.step_iterations),
         static_cast<double>(at.bifurcations), static_cast<double>(at.steps), static_cast<double>(at.iterations),
         static_cast<double>(at.factorizations), static_cast<double>(critical_points_)});
  }
  [[nodiscard]] PathPosition position(const Recorder::Restart& restart) {
    const auto& t = restart.totals;
    PathPosition at;
    at.stage = static_cast<int>(t.at(0));
    at.load_factor = restart.time;
    at.q = restart.q;
    at.step_q = restart.v;
    at.step_load = t.at(1);
    at.arc_length = restart.step_size;
    at.step_iterations = static_cast<int>(t.at(2));
    at.bifurcations = static_cast<int>(t.at(3));
    at.steps = std::lround(t.at(4));
    at.iterations = std::lround(t.at(5));
    at.factorizations = std::lround(t.at(6));
    critical_points_ = static_cast<int>(t.at(7));
    return at;
  }

 private:
  [[nodiscard]] EnergyAudit::Balance balance(const PathPosition& at) const {
    EnergyAudit::Balance b;
    b.energies = model_.system->energies({at.load_factor, at.q, still_, at.stage});
    b.external_work = work_;
    return b;
  }

  const Case& case_;
  const CaseModel& model_;
  Recorder& recorder_;
  Progress& progress_;
  Vector still_, before_;  // 3P
  double before_load_ = 0, work_ = 0;
  Mishaps mishaps_;
  std::optional<std::string> mishap_;
  StopRequest stop_;
  PathStep last_;
  long framed_ = -1;
  int critical_points_ = 0, warnings_ = 0;
};

}  // namespace

AnalysisEnd run_arc_length(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress) {
  const auto& system = *model.system;
  const auto options = path_options(c, model);
  Watch watch(c, model, recorder, progress);
  PathPosition at;
  at.q = model.initial;
  if (const auto& restart = recorder.restart()) {
    at = watch.position(*restart);
    progress.say(fmt::format("resuming at load factor {:.6g} of stage {}", at.load_factor, at.stage));
  } else {
    watch.frame(at);
  }
  watch.start_from(at);

  auto result = follow_path(system, options, at, watch);

  recorder.statistic("path_steps", static_cast<std::int64_t>(at.steps), "accepted steps of the path");
  recorder.statistic("newton_iterations", static_cast<std::int64_t>(at.iterations),
                     "corrections, of rejected tries too");
  recorder.statistic("factorizations", static_cast<std::int64_t>(at.factorizations), "matrices factored");
  recorder.statistic("critical_points", static_cast<std::int64_t>(watch.critical_points()),
                     "limit points and bifurcations that the path met");
  recorder.statistic("load_factor", at.load_factor, "where the path ended");
  recorder.statistic("stage", static_cast<std::int64_t>(at.stage), "where the path ended");
  AnalysisEnd end;
  const auto where = fmt::format("load factor {:.6g} of stage {}", at.load_factor, at.stage);
  if (result.end == PathEnd::complete) {
    auto known = watch.last().negative_pivots;
    if (!known)  // resumed at its end
      known = negative_pivots(system, {at.load_factor, at.q, Vector::Zero(at.q.size()), at.stage},
                              options.neutral_frequency);
    int pivots = known.value_or(-1);
    if (pivots > 0 && c.arc_length.relax_unstable) {
      UnseenRelaxation unseen([&] { return watch.wants_to_stop(); });
      Vector q = at.q;
      const auto solver = statics_solver(c, system);
      const auto fallen = relax_to_stable_neighbour(system, *solver, options.relaxation, options.push,
                                                    options.neutral_frequency, q, unseen);
      if (fallen.result.end == RelaxationEnd::converged) {
        progress.say(
            fmt::format("the end had {} negative pivots; pushed along its unstable mode and relaxed, it has {}", pivots,
                        fallen.pivots.value_or(-1)));
        pivots = fallen.pivots.value_or(-1);
        at.q = q;
        watch.frame(at, {.residual = fallen.result.residual, .negative_pivots = fallen.pivots});
      } else if (fallen.result.end == RelaxationEnd::stopped) {
        result.end = PathEnd::stopped;
      } else {
        recorder.warn("the unstable equilibrium at the end was kept: " + fallen.result.diagnosis);
      }
    }
    if (pivots > 0 && result.end == PathEnd::complete)
      recorder.warn(
          fmt::format("the equilibrium at the end is unstable: its tangent has {} negative pivots; "
                      "arc-length.unstable_end = \"relax\" goes on to the stable one next to it",
                      pivots));
  }
  if (watch.mishap()) {
    end = {ResultStatus::failed, fmt::format("at {}: {}", where, *watch.mishap())};
  } else if (result.end != PathEnd::complete && watch.out_of_time()) {
    end = {ResultStatus::failed, out_of_time_message(*c.arc_length.time_limit, "at " + where, "arc-length")};
  } else if (result.end == PathEnd::stopped) {
    end = {ResultStatus::interrupted, fmt::format("interrupted at {}: continue with --resume", where)};
  } else if (result.end == PathEnd::stalled) {
    end = {ResultStatus::failed, result.diagnosis};
  } else if (result.end == PathEnd::at_bifurcation) {
    progress.say("stopped at the bifurcation, as arc-length.at_bifurcation says");
  }
  if (at.q.allFinite() && watch.is_new(at)) watch.frame(at);
  if (at.q.allFinite()) watch.checkpoint(at);
  return end;
}

}  // namespace sundrape

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "sundrape/app/analyses.hpp"
#include "sundrape/app/interrupt.hpp"
#include "sundrape/app/solver_choice.hpp"
#include "sundrape/statics/chapter_relaxation.hpp"
#include "sundrape/statics/relaxation.hpp"
#include "sundrape/statics/stability.hpp"

namespace sundrape {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int frame_every = 5;  // iterations

/// Loads without a potential do no work that a fictitious motion could account for; what dead loads did is exact.
EnergyAudit::Balance balance_of(const System& system, const State& all, double initial_load) {
  EnergyAudit::Balance b;
  b.energies = system.energies(all);
  b.external_work = initial_load - b.energies.load;
  return b;
}

class Watch final : public RelaxationObserver {
 public:
  Watch(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress, double initial_load,
        double first_step)
      : case_(c),
        model_(model),
        recorder_(recorder),
        progress_(progress),
        initial_load_(initial_load),
        still_(Vector::Zero(model.initial.size())),
        start_(Clock::now()) {
    now_.step_size = first_step;
    if (const auto& restart = recorder.restart())
      before_ = now_ = {restart->time, restart->step_size, restart->totals.at(0), restart->totals.at(1)};
  }

  void step(const State& all, const RelaxationStep& step) override {
    if (due_) {  // not at once: what turns out to be the last frame is written with its stability
      frame(*due_);
      checkpoint(*due_);
      due_.reset();
    }
    const int factored = case_.relaxation.scheme == "chapter" ? 0 : 1 + step.refused;
    now_ = {before_.time + step.time, step.step_size, before_.iterations + step.iteration,
            now_.factorizations + factored};
    const auto contact = recorder_.step({now_.time, all.q, all.v});
    recorder_.step_values({{"time", now_.time},
                           {"step_size", step.step_size},
                           {"residual", step.residual},
                           {"newton_iterations", 1},
                           {"contacts", contact.contacts},
                           {"negative_pivots", -1}});
    if (++steps_ % frame_every == 0) due_ = all.q;
    if (progress_.due())
      progress_.show(fmt::format("iteration {}, residual {:.2e}, step {:.2e} s, {} contacts", now_.iterations,
                                 step.residual, step.step_size, contact.contacts),
                     -1);
  }

  /// How far the relaxation is, from its very start.
  struct Course {
    double time = 0, step_size = 0;  // of the fictitious motion [s]
    double iterations = 0, factorizations = 0;
  };
  [[nodiscard]] const Course& before() const { return before_; }
  /// Whether this state has no frame yet.
  [[nodiscard]] bool is_new() const { return steps_ > 0; }

  [[nodiscard]] bool wants_to_stop() override {
    if (case_.relaxation.time_limit &&
        std::chrono::duration<double>(Clock::now() - start_).count() > *case_.relaxation.time_limit)
      out_of_time_ = true;
    return out_of_time_ || InterruptGuard::requested();
  }
  [[nodiscard]] bool out_of_time() const { return out_of_time_; }

  void frame(const Vector& q, std::optional<int> pivots = std::nullopt) {
    const State all{now_.time, q, still_};
    recorder_.frame(all, balance_of(*model_.system, all, initial_load_), pivots);
  }
  void checkpoint(const Vector& q) {
    const State all{now_.time, q, still_};
    recorder_.checkpoint(all, balance_of(*model_.system, all, initial_load_), 0, now_.step_size,
                         {now_.iterations, now_.factorizations});
  }

 private:
  const Case& case_;
  const CaseModel& model_;
  Recorder& recorder_;
  Progress& progress_;
  double initial_load_;
  Vector still_;
  Clock::time_point start_;
  Course before_, now_;
  std::optional<Vector> due_;  // positions that wait to become a frame
  bool out_of_time_ = false;
  int steps_ = 0;
};

double shortest_edge(const QuadMesh& mesh) {
  double shortest = diagonal(mesh);
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k)
      shortest = std::min(shortest, (mesh.reference[static_cast<std::size_t>(quad[k])] -
                                     mesh.reference[static_cast<std::size_t>(quad[(k + 1) % 4])])
                                        .norm());
  return shortest;
}

}  // namespace

AnalysisEnd run_relaxation(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress) {
  const auto& system = *model.system;
  const double swing = std::sqrt(model.size / model.gravity);  // time scale of motion under gravity [s]
  const double force_scale = c.fabric.area_density * model.gravity * model.size * model.size;
  Vector q = model.initial;
  auto options = relaxation_options(model.size, model.gravity);
  double first_step = c.relaxation.first_step.value_or(options.first_step);
  if (const auto& restart = recorder.restart()) {
    q = restart->q;
    first_step = restart->step_size;
    progress.say(fmt::format("resuming after {} frames", recorder.frames()));
  }
  const Vector still = Vector::Zero(q.size());
  const double initial_load = system.energies({0, model.initial, still}).load;
  Watch watch(c, model, recorder, progress, initial_load, first_step);
  if (!recorder.restart()) watch.frame(q);

  RelaxationResult result;
  if (c.relaxation.scheme == "chapter") {
    const auto found = relax_as_in_chapter(system,
                                           {.c_disp = c.relaxation.c_disp.value_or(0),
                                            .c_acc = c.relaxation.c_acc.value_or(-1),
                                            .edge_length = shortest_edge(model.mesh),
                                            .tolerance = c.relaxation.tolerance,
                                            .max_iterations = c.relaxation.max_iterations.value_or(1000000),
                                            .force_scale = force_scale},
                                           q, watch);
    recorder.statistic("chapter_criterion_iterations", static_cast<std::int64_t>(found.criterion_iterations),
                       "steps after which no node moved further than b/10,000: where the chapter stops");
    recorder.statistic("chapter_criterion_residual", found.criterion_residual,
                       "|out-of-balance force| / |external force| there");
    result = found;
  } else {
    const auto solver = statics_solver(c, system);
    options.tolerance = c.relaxation.tolerance;
    options.max_iterations = c.relaxation.max_iterations.value_or(options.max_iterations);
    options.first_step = first_step;
    options.growth = c.relaxation.growth;
    options.force_scale = force_scale;
    result = relax(system, *solver, options, q, watch);
  }

  recorder.statistic("iterations", static_cast<std::int64_t>(watch.before().iterations) + result.iterations,
                     "steps of the relaxation");
  recorder.statistic("factorizations", static_cast<std::int64_t>(watch.before().factorizations) + result.factorizations,
                     "matrices factored");
  recorder.statistic("residual", result.residual, "|out-of-balance force| / |external force| at the end");
  AnalysisEnd end;
  std::optional<int> pivots;
  if (result.end == RelaxationEnd::converged) {
    pivots = negative_pivots(system, {0, q, still}, 1e-3 / swing);
    recorder.statistic("negative_pivots", static_cast<std::int64_t>(pivots.value_or(-1)),
                       "of the tangent at the end: 0 means a stable equilibrium, -1 that the factorisation broke down");
    if (!pivots)
      recorder.warn("the stability of this equilibrium is not known: the tangent's factorisation broke down");
    else if (*pivots > 0)
      recorder.warn(
          fmt::format("this equilibrium is unstable: its tangent has {} negative pivots; another cloth.waviness leads "
                      "to a stable one",
                      *pivots));
  } else if (watch.out_of_time()) {
    end = {
        ResultStatus::failed,
        fmt::format(
            "time limit of {:g} s reached with residual {:.3g}: continue with --resume, or raise relaxation.time_limit",
            *c.relaxation.time_limit, result.residual)};
  } else if (result.end == RelaxationEnd::stopped) {
    end = {ResultStatus::interrupted,
           fmt::format("interrupted with residual {:.3g}: continue with --resume", result.residual)};
  } else {
    end = {ResultStatus::failed, result.diagnosis};
  }
  if (q.allFinite()) {
    if (watch.is_new()) watch.frame(q, pivots);
    watch.checkpoint(q);
  }
  return end;
}

}  // namespace sundrape

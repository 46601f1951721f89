#include <cmath>

#include <fmt/format.h>

#include "sundrape/app/analyses.hpp"
#include "sundrape/app/continuation.hpp"
#include "sundrape/app/solver_choice.hpp"
#include "sundrape/app/stop_request.hpp"
#include "sundrape/statics/chapter_relaxation.hpp"
#include "sundrape/statics/stability.hpp"
#include "sundrape/statics/stable_neighbour.hpp"

#include "relaxation_watch.hpp"

namespace sundrape {
namespace {

double shortest_edge(const QuadMesh& mesh) {
  double shortest = diagonal(mesh);
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k)
      shortest = std::min(shortest, (mesh.reference[static_cast<std::size_t>(quad[k])] -
                                     mesh.reference[static_cast<std::size_t>(quad[(k + 1) % 4])])
                                        .norm());
  return shortest;
}

/// An equilibrium that may have been looked for more than once.
struct Found {
  RelaxationResult result;
  std::optional<int> pivots;  // of a converged one; nothing where the factorisation broke down
};

std::optional<int> pivots_at(const CaseModel& model, const Vector& q) {
  return negative_pivots(*model.system, {0, q, Vector::Zero(q.size())}, neutral_frequency(model));
}

Found relax_by_chapter(const Case& c, const CaseModel& model, double force_scale, Vector& q, Recorder& recorder,
                       RelaxationWatch& watch) {
  const auto found = relax_as_in_chapter(*model.system,
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
  return {found, found.end == RelaxationEnd::converged ? pivots_at(model, q) : std::nullopt};
}

/// One relaxation after another until one of them ends as it should: from coarser meshes, then from where the case
/// starts.
class ImplicitRelaxation {
 public:
  ImplicitRelaxation(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress,
                     RelaxationWatch& watch)
      : c_(c), model_(model), recorder_(recorder), progress_(progress), watch_(watch) {}

  Found find(Vector& q) {
    if (!recorder_.restart() && c_.relaxation.continuation && continued(q)) return found_;
    auto options = relaxation_options(c_, model_);
    options.first_step = watch_.now().step_size;
    relax_on_own_mesh(q, options);
    return found_;
  }

 private:
  void relax_on_own_mesh(Vector& q, const RelaxationOptions& options) {
    const auto solver = statics_solver(c_, *model_.system);
    found_.result = after(found_.result, relax(*model_.system, *solver, options, q, watch_));
    if (found_.result.end == RelaxationEnd::converged) found_.pivots = pivots_at(model_, q);
  }

  /// False if it leads nowhere: q is then where the case starts.
  bool continued(Vector& q) {
    const auto coarser = coarser_cases(c_, model_);
    if (coarser.empty()) {
      progress_.remark("no coarser mesh with the same supports and loads to start from");
      return false;
    }
    const auto start = start_on_coarser_meshes(
        c_, model_, coarser, [&](const QuadMesh& mesh, const RelaxationStep& step) { watch_.coarse_step(mesh, step); },
        [&] { return watch_.wants_to_stop(); });
    recorder_.statistic("coarse_meshes", std::int64_t{start.meshes}, "coarser meshes relaxed to start from");
    recorder_.statistic("coarse_iterations", std::int64_t{start.iterations}, "steps of the relaxation on them");
    recorder_.statistic("coarse_factorizations", std::int64_t{start.factorizations}, "matrices factored for them");
    if (!start.problem.empty()) {
      progress_.remark("starting from the placed sheet: " + start.problem);
      return false;
    }
    progress_.remark(fmt::format("{} coarser meshes, {} iterations", start.meshes, start.iterations));
    q = start.q;
    watch_.begin_again(q, start.time, start.step_size);
    if (start.stopped) {
      found_.result.end = RelaxationEnd::stopped;
      found_.result.residual =
          relative_residual(*model_.system, {0, q, Vector::Zero(q.size())}, relaxation_options(c_, model_).force_scale);
      return true;
    }
    relax_on_own_mesh(q, continued_options(c_, model_));
    const auto end = found_.result.end;
    if (end == RelaxationEnd::stopped || (end == RelaxationEnd::converged && found_.pivots.value_or(0) == 0))
      return true;
    progress_.remark("starting again from the placed sheet: " +
                     (end == RelaxationEnd::stalled ? found_.result.diagnosis
                                                    : fmt::format("{} negative pivots", found_.pivots.value_or(0))));
    q = model_.initial;
    watch_.begin_again(q, watch_.now().time + start.step_size, relaxation_options(c_, model_).first_step);
    return false;
  }

  const Case& c_;
  const CaseModel& model_;
  Recorder& recorder_;
  Progress& progress_;
  RelaxationWatch& watch_;
  Found found_;
};

}  // namespace

AnalysisEnd run_relaxation(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress) {
  const auto options = relaxation_options(c, model);
  RelaxationWatch watch(c, model, recorder, progress, options.first_step);
  Vector q = model.initial;
  if (const auto& restart = recorder.restart()) {
    q = restart->q;
    progress.say(
        fmt::format("resuming after {} frames, without the momentum that the relaxation had: of several "
                    "equilibria it may find another one",
                    recorder.frames()));
  } else {
    watch.frame(q);
  }

  Found found;
  const auto before = watch.now();
  if (c.relaxation.scheme == "chapter")
    found = relax_by_chapter(c, model, options.force_scale, q, recorder, watch);
  else
    found = ImplicitRelaxation(c, model, recorder, progress, watch).find(q);
  if (found.result.end == RelaxationEnd::converged && found.pivots.value_or(0) > 0 && c.relaxation.relax_unstable) {
    progress.say(fmt::format("this equilibrium has {} negative pivots: relaxing from it along its unstable mode",
                             *found.pivots));
    watch.begin_again(q, watch.now().time, options.first_step);
    const auto solver = statics_solver(c, *model.system);
    const auto fallen = relax_to_stable_neighbour(*model.system, *solver, options, push_of_unstable(model),
                                                  neutral_frequency(model), q, watch);
    found = {after(found.result, fallen.result), fallen.pivots};
  }
  const auto& result = found.result;

  recorder.statistic("iterations", static_cast<std::int64_t>(before.iterations) + result.iterations,
                     "steps of the relaxation");
  recorder.statistic("factorizations", static_cast<std::int64_t>(before.factorizations) + result.factorizations,
                     "matrices factored, completely or incompletely");
  recorder.statistic("residual", result.residual, "|out-of-balance force| / |external force| at the end");
  AnalysisEnd end;
  if (result.end == RelaxationEnd::converged) {
    recorder.statistic("negative_pivots", static_cast<std::int64_t>(found.pivots.value_or(-1)),
                       "of the tangent at the end: 0 means a stable equilibrium, -1 that the factorisation broke down");
    if (!found.pivots)
      recorder.warn("the stability of this equilibrium is not known: the tangent's factorisation broke down");
    else if (*found.pivots > 0)
      recorder.warn(
          fmt::format("this equilibrium is unstable: its tangent has {} negative pivots; relaxation.unstable_end = "
                      "\"relax\" or another cloth.waviness leads to a stable one",
                      *found.pivots));
  } else if (watch.out_of_time()) {
    end = {ResultStatus::failed,
           out_of_time_message(*c.relaxation.time_limit, fmt::format("with residual {:.3g}", result.residual),
                               "relaxation")};
  } else if (result.end == RelaxationEnd::stopped) {
    end = {ResultStatus::interrupted,
           fmt::format("interrupted with residual {:.3g}: continue with --resume", result.residual)};
  } else {
    end = {ResultStatus::failed, result.diagnosis};
  }
  if (q.allFinite()) {
    if (watch.is_new()) watch.frame(q, found.pivots);
    watch.checkpoint(q);
  }
  return end;
}

}  // namespace sundrape

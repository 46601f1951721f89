#include <algorithm>

#include <fmt/format.h>

#include "sundrape/app/analyses.hpp"
#include "sundrape/app/mishaps.hpp"
#include "sundrape/app/solver_choice.hpp"
#include "sundrape/app/stop_request.hpp"
#include "sundrape/statics/follow_supports.hpp"
#include "sundrape/statics/stability.hpp"
#include "sundrape/statics/stable_neighbour.hpp"

namespace sundrape {
namespace {

/// How far obstacles between two times carry what is where the nodes of the cloth are [m].
double way_of_obstacles(const CaseModel& model, const Vector& q, double from, double to) {
  if (model.contact == nullptr) return 0;
  const Vector nothing;
  const auto at = [&](double time) { return State{time, nothing, nothing, statics_by_time}; };
  double most = 0;
  for (std::size_t b = 0; b < model.contact->bodies(); ++b) {
    if (!model.contact->moves(b)) continue;
    const auto before = model.contact->carried(b, at(from)), after = model.contact->carried(b, at(to));
    for (int n = 0; n < model.mesh.nodes(); ++n) {
      const Vector3 x = point(q, n);
      most = std::max(most, (after(before.inverse(x)) - x).norm());
    }
  }
  return most;
}

/// Follows supports and obstacles from one chosen time to the next; each equilibrium there is a frame, a step and a
/// checkpoint.
class QuasiStaticRun final : public RelaxationObserver {
 public:
  QuasiStaticRun(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress)
      : case_(c),
        model_(model),
        recorder_(recorder),
        progress_(progress),
        mishaps_(c, model),
        stop_(c.relaxation.time_limit),
        solver_(statics_solver(c, *model.system)),
        options_{.relaxation = relaxation_options(c, model),
                 .neutral_frequency = neutral_frequency(model),
                 .way_of_obstacles = [&model](const Vector& q, double from,
                                              double to) { return way_of_obstacles(model, q, from, to); }},
        q_(model.initial),
        still_(Vector::Zero(q_.size())) {}

  AnalysisEnd run() {
    const auto& times = case_.relaxation.times;
    std::size_t next = 0;
    if (const auto& restart = recorder_.restart()) {
      q_ = restart->q;
      time_ = restart->time;
      work_ = restart->balance.external_work;
      initial_energy_ = restart->initial_energy;
      iterations_ = static_cast<int>(restart->totals.at(0));
      factorizations_ = static_cast<int>(restart->totals.at(1));
      while (next < times.size() && times[next] <= time_) ++next;
      progress_.say(fmt::format("resuming after the equilibrium at t = {:.6g} s", time_));
    }
    AnalysisEnd end;
    for (; next < times.size() && end.status == ResultStatus::done; ++next) end = advance(times[next], next == 0);
    recorder_.statistic("iterations", std::int64_t{iterations_}, "steps of all relaxations");
    recorder_.statistic("factorizations", std::int64_t{factorizations_}, "matrices factored");
    recorder_.statistic("equilibria", static_cast<std::int64_t>(recorder_.frames()), "found, one a frame");
    return end;
  }

  void step(const State& all, const RelaxationStep& step) override {
    if (!mishap_) mishap_ = mishaps_.at({step.load_factor, all.q, still_, statics_by_time});
    if (progress_.due())
      progress_.show(fmt::format("supports at t = {:.4f} s: iteration {}, residual {:.2e}, step {:.2e} s", time_,
                                 iterations_ + step.iteration, step.residual, step.step_size),
                     time_ / case_.relaxation.times.back());
  }
  [[nodiscard]] bool wants_to_stop() override { return mishap_.has_value() || stop_.wanted(); }

 private:
  AnalysisEnd advance(double time, bool first) {
    auto found = to(time, first);
    const State here{found.time, q_, still_, statics_by_time};
    if (!mishap_) mishap_ = mishaps_.at(here);
    std::optional<int> pivots;
    if (found.relaxation.end == RelaxationEnd::converged && !mishap_) {
      pivots = negative_pivots(*model_.system, here, neutral_frequency(model_));
      if (pivots.value_or(0) > 0 && case_.relaxation.relax_unstable) pivots = fall(found);
    }
    iterations_ += found.relaxation.iterations;
    factorizations_ += found.relaxation.factorizations;
    if (found.relaxation.end == RelaxationEnd::converged && !mishap_) {
      work_ += found.work;
      record(time, found.relaxation, pivots);
      return {};
    }
    const auto where = fmt::format("on the way to t = {:.6g} s, at {:.6g} s", time, found.time);
    if (mishap_) return {ResultStatus::failed, fmt::format("{}: {}", where, *mishap_)};
    if (stop_.out_of_time())
      return {ResultStatus::failed, out_of_time_message(*case_.relaxation.time_limit, where, "relaxation")};
    if (found.relaxation.end == RelaxationEnd::stopped)
      return {ResultStatus::interrupted, fmt::format("interrupted {}: continue with --resume", where)};
    return {ResultStatus::failed, fmt::format("{}: {}", where, found.relaxation.diagnosis)};
  }

  /// The first equilibrium is looked for where supports and obstacles set out.
  FollowResult to(double time, bool first) {
    RelaxationResult start;
    if (first) {
      auto options = options_.relaxation;
      options.load_factor = time_;
      options.stage = statics_by_time;
      start = relax(*model_.system, *solver_, options, q_, *this);
      initial_energy_ = model_.system->energies({time_, q_, still_, statics_by_time}).total();
      if (time == time_ || start.end != RelaxationEnd::converged) return {start, time_};
    }
    auto found = follow_supports(*model_.system, *solver_, options_, time_, time, q_, *this);
    found.relaxation = after(start, found.relaxation);
    return found;
  }

  std::optional<int> fall(FollowResult& found) {
    auto options = options_.relaxation;
    options.load_factor = found.time;
    options.stage = statics_by_time;
    const auto fallen = relax_to_stable_neighbour(*model_.system, *solver_, options, push_of_unstable(model_),
                                                  neutral_frequency(model_), q_, *this);
    found.relaxation = after(found.relaxation, fallen.result);
    return fallen.pivots;
  }

  void record(double time, const RelaxationResult& found, std::optional<int> pivots) {
    const State all{time, q_, still_, statics_by_time};
    const auto contact = recorder_.step(all);
    EnergyAudit::Balance balance;
    balance.energies = model_.system->energies(all);
    const double energy = balance.energies.total();
    balance.external_work = work_;
    // where the sheet fell to another equilibrium, and what obstacles that move put in
    balance.method_dissipated = initial_energy_ + work_ - energy;
    recorder_.frame(all, balance, pivots);
    recorder_.step_values({{"time", time},
                           {"step_size", time - time_},
                           {"residual", found.residual},
                           {"newton_iterations", found.iterations},
                           {"contacts", contact.contacts},
                           {"negative_pivots", pivots.value_or(-1)}});
    recorder_.checkpoint(all, balance, initial_energy_, time - time_,
                         {static_cast<double>(iterations_), static_cast<double>(factorizations_)});
    if (pivots.value_or(0) > 0)
      recorder_.warn(
          fmt::format("the equilibrium at t = {:.6g} s is unstable: {} negative pivots; "
                      "relaxation.unstable_end = \"relax\" falls to a stable one",
                      time, *pivots));
    time_ = time;
  }

  const Case& case_;
  const CaseModel& model_;
  Recorder& recorder_;
  Progress& progress_;
  Mishaps mishaps_;
  StopRequest stop_;
  std::unique_ptr<LinearSolver> solver_;
  FollowOptions options_;
  Vector q_;                              // the last state reached
  Vector still_;                          // no rates
  double work_ = 0, initial_energy_ = 0;  // of the supports so far; of the first equilibrium [J]
  double time_ = 0;                       // of the last equilibrium that was recorded [s]
  int iterations_ = 0, factorizations_ = 0;
  std::optional<std::string> mishap_;
};

}  // namespace

AnalysisEnd run_quasi_static(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress) {
  return QuasiStaticRun(c, model, recorder, progress).run();
}

}  // namespace sundrape

#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "sundrape/app/analyses.hpp"
#include "sundrape/app/mishaps.hpp"
#include "sundrape/app/rest_watch.hpp"
#include "sundrape/app/solver_choice.hpp"
#include "sundrape/app/stop_request.hpp"
#include "sundrape/app/support_schedule.hpp"
#include "sundrape/integrate/dynamics.hpp"
#include "sundrape/integrate/impact.hpp"
#include "sundrape/integrate/stability_limit.hpp"
#include "sundrape/io/file_error.hpp"

namespace sundrape {
namespace {

using Clock = std::chrono::steady_clock;

/// The law of friction begins with the slope 3 μ p/s₀; edges of obstacles carry several times the weight above them.
ContactRates contact_rates(const Case& c, const CaseModel& model) {
  double density = std::numeric_limits<double>::infinity(), stiffness = 0, friction = 0;
  for (const auto& piece : c.pieces) density = std::min(density, piece.fabric.area_density);
  if (model.contact != nullptr) {
    stiffness = model.contact->law().stiffness();
    friction = model.contact->largest_friction();
  }
  if (model.cloth_contact != nullptr) {  // of two layers each other's: twice as stiff for half the mass
    stiffness = std::max(stiffness, 4 * model.cloth_contact->law().stiffness());
    friction = std::max(friction, 2 * model.cloth_contact->options().friction);
  }
  constexpr double concentration = 10;
  const double push = concentration * model.area_weight;
  return {std::sqrt(stiffness / density), 3 * friction * push / c.contact.friction_speed / density};
}

/// With all grippers open: what they hold at the start they may let go of.
StabilityLimit stability_limit(const Case& c, const CaseModel& model) {
  const Vector still = Vector::Zero(model.initial.size());
  const State start{0, model.initial, still};
  for (const auto& gripper : model.grippers) model.system->let_go(gripper.motion, start);
  const auto limit = rk4_stability_limit(*model.system, start, contact_rates(c, model));
  for (const auto& gripper : model.grippers)
    if (!gripper.at_start.empty())
      model.system->take_hold(gripper.motion, gripper.at_start, model.turned_points(gripper, gripper.at_start), start);
  return limit;
}

std::unique_ptr<Integrator> make_integrator(const Case& c, const CaseModel& model, EventSource* events,
                                            Recorder& recorder, Progress& progress) {
  auto options = integrator_options(c, model);
  const auto& d = c.dynamics;
  if (d.integrator == IntegratorKind::rk4) {
    const auto limit = stability_limit(c, model);
    recorder.statistic("rk4_stable_step_s", limit.step,
                       "largest stable step of the Runge-Kutta method, from the stiffest mode of the start [s]");
    recorder.statistic("stiffest_angular_frequency_per_s", limit.angular_frequency,
                       "of the stiffest mode of the start [1/s]");
    options.fixed_step = d.step.value_or(0.8 * limit.step);
    progress.say(fmt::format(
        "RK4: stable up to a step of {:.3g} s (stiffest mode {:.4g} rad/s, damping rate {:.4g} 1/s); taking {:.3g} s",
        limit.step, limit.angular_frequency, limit.damping_rate, options.fixed_step));
    if (options.fixed_step > limit.step)
      recorder.warn(
          fmt::format("dynamics.step = {:.3g} s is above the stability limit of {:.3g} s: the motion will blow up",
                      options.fixed_step, limit.step));
    return make_rk4(*model.system, options, events);
  }
  auto solver = dynamics_solver(c);
  if (d.integrator == IntegratorKind::ida) return make_ida(*model.system, std::move(solver), options, events);
  if (d.integrator == IntegratorKind::dirk) return make_dirk(*model.system, std::move(solver), options, events);
  return make_cvode(*model.system, std::move(solver), options, events);
}

/// Every number that an integrator counts, in the order that checkpoints have.
template <class Statistics, class Visit>
void visit_totals(Statistics& s, Visit&& visit) {
  visit(s.steps), visit(s.force_evaluations), visit(s.newton_iterations), visit(s.error_test_failures),
      visit(s.step_solve_failures), visit(s.restarts);
  visit(s.linear.factorizations), visit(s.linear.solves), visit(s.linear.linear_iterations), visit(s.linear.failures);
  visit(s.linear.assembly_seconds), visit(s.linear.factor_seconds), visit(s.linear.solve_seconds);
  visit(s.linear.patterns);
}

/// An integrator's counts on top of those of the run that it resumes.
IntegratorStatistics since_the_start(IntegratorStatistics s, const std::optional<Recorder::Restart>& restart) {
  if (restart) {
    std::size_t k = 0;
    visit_totals(s, [&](auto& total) { total += static_cast<std::decay_t<decltype(total)>>(restart->totals.at(k++)); });
  }
  return s;
}

std::vector<double> as_list(const IntegratorStatistics& s) {
  std::vector<double> list;
  visit_totals(s, [&](const auto& total) { list.push_back(static_cast<double>(total)); });
  return list;
}

/// Sensitivities at a state, as a checkpoint keeps them: coordinates' and rates', parameter by parameter.
std::vector<double> listed(const ForwardSensitivity& sensitivity, const State& all) {
  std::vector<double> list;
  Vector s(all.q.size()), s_dot(all.q.size());
  for (std::size_t k = 0; k < sensitivity.parameters(); ++k) {
    sensitivity.at(all.time, k, s, s_dot);
    list.insert(list.end(), s.begin(), s.end());
    list.insert(list.end(), s_dot.begin(), s_dot.end());
  }
  return list;
}

/// Where sensitivities begin: with the case's start, or where a checkpoint left them.
void set_out(ForwardSensitivity& sensitivity, const std::vector<Vector>& of_start,
             const std::optional<Recorder::Restart>& restart) {
  auto q = of_start;
  std::vector<Vector> v;
  for (const auto& s : of_start) v.emplace_back(Vector::Zero(s.size()));
  if (restart) {
    const auto size = of_start.front().size();
    if (restart->sensitivities.size() != 2 * q.size() * static_cast<std::size_t>(size))
      throw FileError("the checkpoint holds no sensitivities, or those by other parameters: it cannot be resumed");
    const double* next = restart->sensitivities.data();
    for (std::size_t k = 0; k < q.size(); ++k)
      for (auto* s : {&q[k], &v[k]}) {
        *s = Eigen::Map<const Vector>(next, size);
        next += size;
      }
  }
  sensitivity.set(q, v);
}

/// The case's own timetable, followed by the models around it.
class SharedSchedule final : public Timetable {
 public:
  SharedSchedule(SupportSchedule& own, const std::vector<const CaseModel*>& others) : own_(own) {
    for (const auto* model : others) others_.emplace_back(*model);
  }
  [[nodiscard]] double next() const override { return own_.next(); }
  void happen(const State& all) override {
    own_.happen(all);
    for (auto& other : others_) other.happen(all);
  }
  void resume(const std::vector<double>& progress, const State& all) {
    own_.resume(progress, all);
    for (auto& other : others_) other.resume(progress, all);
  }

 private:
  SupportSchedule& own_;
  std::vector<SupportSchedule> others_;
};

class Watch final : public DynamicsObserver {
 public:
  Watch(const Case& c, const CaseModel& model, const Integrator& integrator, const SupportSchedule& schedule,
        Recorder& recorder, Progress& progress)
      : case_(c),
        integrator_(integrator),
        schedule_(schedule),
        recorder_(recorder),
        progress_(progress),
        mishaps_(c, model),
        stop_(c.dynamics.time_limit),
        last_checkpoint_(Clock::now()) {
    if (c.dynamics.until_rest) rest_.emplace(model, *c.dynamics.until_rest, c.settled_after());
    if (recorder.restart()) last_step_size_ = recorder.restart()->step_size;
  }

  void attach(Dynamics& dynamics) { dynamics_ = &dynamics; }
  void attach(const ForwardSensitivity& sensitivity) { sensitivity_ = &sensitivity; }

  void frame(const State& all, const EnergyAudit::Balance& balance) override {
    recorder_.frame(
        all, balance, std::nullopt, std::nullopt,
        sensitivity_ ? recorder_.sensitivities()->of_motion(*sensitivity_, all.time) : std::vector<FrameSensitivity>{});
    last_frame_ = all.time;
    if (case_.contact.self && recorder_.first_crossing() && !mishap_)
      tangle_ =
          "cloth has passed through cloth (/frames/crossings): try a smaller dynamics.rtol or max_step, a thicker "
          "or stiffer contact, or a finer mesh";
  }

  void step(const State& all, const StepReport& report, const Integrator& integrator) override {
    const auto contact = recorder_.step(all);
    const auto s = integrator.statistics();
    const auto since = [](long now, long& before) { return static_cast<double>(now - std::exchange(before, now)); };
    recorder_.step_values({{"time", report.time},
                           {"step_size", report.step_size},
                           {"order", report.order},
                           {"newton_iterations", since(s.newton_iterations, newton_)},
                           {"linear_iterations", since(s.linear.linear_iterations, linear_)},
                           {"error_test_failures", since(s.error_test_failures, error_failures_)},
                           {"convergence_failures", since(s.step_solve_failures, solve_failures_)},
                           {"contacts", contact.contacts}});
    last_step_size_ = report.step_size;
    if (rest_) rest_->step(all);
    mishap_ = tangle_ ? tangle_ : mishaps_.at(all);
    fastest_creep_ = contact.fastest_creep;
    if (!checkpoint_written_ ||
        std::chrono::duration<double>(Clock::now() - last_checkpoint_).count() > case_.output.checkpoint_every)
      checkpoint();
    if (progress_.due())
      progress_.show(
          fmt::format("t = {:.4f} s, step {:.2e} s, order {}, {} steps, {} Newton iterations, {} contacts", report.time,
                      report.step_size, report.order, s.steps, s.newton_iterations, contact.contacts),
          report.time / case_.output.frame_times.back());
  }

  [[nodiscard]] bool wants_to_stop() override { return mishap_ || rests() || stop_.wanted(); }
  [[nodiscard]] const std::optional<std::string>& mishap() const { return mishap_; }
  /// Of what friction held when the last step ended [m/s].
  [[nodiscard]] double fastest_creep() const { return fastest_creep_; }
  [[nodiscard]] bool out_of_time() const { return stop_.out_of_time(); }
  [[nodiscard]] bool rests() const { return rest_ && rest_->rests(); }

  void checkpoint() {
    const auto at = dynamics_->last();
    recorder_.checkpoint(at, dynamics_->audit().at(at), dynamics_->audit().initial_energy(), last_step_size_,
                         as_list(since_the_start(integrator_.statistics(), recorder_.restart())), schedule_.progress(),
                         sensitivity_ ? listed(*sensitivity_, at) : std::vector<double>{});
    checkpoint_written_ = true;
    last_checkpoint_ = Clock::now();
  }

  /// Where the run ended between two frame times.
  void frame_of_the_end() {
    const auto at = dynamics_->last();
    if (at.time > last_frame_) frame(at, dynamics_->audit().at(at));
  }

 private:
  const Case& case_;
  const Integrator& integrator_;
  const SupportSchedule& schedule_;
  Recorder& recorder_;
  Progress& progress_;
  Dynamics* dynamics_ = nullptr;
  const ForwardSensitivity* sensitivity_ = nullptr;
  Mishaps mishaps_;
  std::optional<std::string> mishap_, tangle_;
  double fastest_creep_ = 0;
  StopRequest stop_;
  Clock::time_point last_checkpoint_;
  bool checkpoint_written_ = false;
  std::optional<RestWatch> rest_;
  double last_step_size_ = 0, last_frame_ = -1;
  long newton_ = 0, linear_ = 0, error_failures_ = 0, solve_failures_ = 0;
};

void record_statistics(const IntegratorStatistics& s, const EnergyAudit::Balance& balance, Recorder& recorder) {
  const auto integer = [&](const char* name, long value, const char* description) {
    recorder.statistic(name, static_cast<std::int64_t>(value), description);
  };
  integer("steps", s.steps, "accepted steps of the integrator");
  integer("force_evaluations", s.force_evaluations, "evaluations of all forces by the integrator");
  integer("newton_iterations", s.newton_iterations, "iterations of Newton's method");
  integer("error_test_failures", s.error_test_failures, "steps that the error test refused");
  integer("step_solve_failures", s.step_solve_failures, "steps that Newton's method could not solve");
  integer("restarts", s.restarts, "restarts of the integrator at events");
  integer("factorizations", s.linear.factorizations, "matrices factored");
  integer("linear_solves", s.linear.solves, "linear systems solved");
  integer("linear_iterations", s.linear.linear_iterations, "iterations of the linear solver");
  integer("patterns", s.linear.patterns, "changes of the matrices' pattern, where cloth touches cloth elsewhere");
  recorder.statistic("assembly_seconds", s.linear.assembly_seconds, "wall-clock time in assembling tangents [s]");
  recorder.statistic("factor_seconds", s.linear.factor_seconds, "wall-clock time in factoring [s]");
  recorder.statistic("solve_seconds", s.linear.solve_seconds, "wall-clock time in linear solves [s]");
  recorder.statistic("method_dissipated_J", balance.method_dissipated,
                     "energy that the integration method itself lost (gained, if negative) [J]");
}

}  // namespace

AnalysisEnd run_dynamics(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress) {
  std::unique_ptr<Impact> impact;
  if (c.contact.restitution && model.contact)
    impact = std::make_unique<Impact>(*model.contact, model.system->mass().head(model.mesh.nodes()),
                                      *c.contact.restitution, c.contact.restitution_speed);
  const auto integrator = make_integrator(c, model, impact.get(), recorder, progress);
  SupportSchedule schedule(model);
  Watch watch(c, model, *integrator, schedule, recorder, progress);
  auto* by = recorder.sensitivities();
  SharedSchedule timetable(schedule, by ? by->models() : std::vector<const CaseModel*>{});
  Dynamics dynamics(*model.system, *integrator, c.output.frame_times, watch, impact.get(), &timetable);
  watch.attach(dynamics);
  std::optional<ForwardSensitivity> sensitivity;
  if (by != nullptr) {
    sensitivity.emplace(by->exact_system(), sensitivity_solver(c), by->derivatives(),
                        c.dynamics.integrator == IntegratorKind::ida ? BdfForm::ida : BdfForm::cvode,
                        c.dynamics.max_order);
    set_out(*sensitivity, by->of_start(), recorder.restart());
    dynamics.carry(*sensitivity);
    watch.attach(*sensitivity);
  }

  AnalysisEnd end;
  bool failed = false;
  try {
    DynamicsEnd how = DynamicsEnd::reached;
    if (const auto& restart = recorder.restart()) {
      progress.say(fmt::format("resuming at t = {:.6g} s after {} frames", restart->time, recorder.frames()));
      timetable.resume(restart->schedule, {restart->time, restart->q, restart->v});
      dynamics.carry_over(restart->balance, restart->initial_energy);
      how = dynamics.run(restart->time, restart->q, restart->v, false);
    } else {
      how = dynamics.run(0, model.initial, Vector::Zero(model.initial.size()), true);
    }
    if (c.dynamics.until_rest && !watch.mishap() && !watch.rests() && how == DynamicsEnd::reached)
      recorder.warn("the cloth does not rest at the end: raise dynamics.duration or material.damping.mass");
    if (watch.mishap()) {
      end = {ResultStatus::failed, fmt::format("at t = {:.6g} s {}", dynamics.last().time, *watch.mishap())};
      failed = true;
    } else if (watch.rests())
      recorder.statistic("rests_at_s", dynamics.last().time, "time at which the cloth was found at rest [s]");
    else if (how == DynamicsEnd::stopped && watch.out_of_time())
      end = {ResultStatus::failed,
             out_of_time_message(*c.dynamics.time_limit, fmt::format("at t = {:.6g} s", dynamics.last().time),
                                 "dynamics")};
    else if (how == DynamicsEnd::stopped)
      end = {ResultStatus::interrupted,
             fmt::format("interrupted at t = {:.6g} s: continue with --resume", dynamics.last().time)};
  } catch (const IntegrationFailure& failure) {
    end = {ResultStatus::failed, failure.what()};
    failed = true;
  }
  const auto last = dynamics.last();
  if (last.q.allFinite() && last.v.allFinite()) {
    if (watch.rests()) watch.frame_of_the_end();
    watch.checkpoint();
    // not part of the checkpoint, so that a resumed run has frames at its frame times only
    if (failed) watch.frame_of_the_end();
  }
  if (model.has_friction())
    recorder.statistic("fastest_creep_m_per_s", watch.fastest_creep(),
                       "of the contact points that friction holds, at the end [m/s]");
  if (sensitivity) {
    const auto& s = sensitivity->counters();
    recorder.statistic("sensitivity_linear_iterations", static_cast<std::int64_t>(sensitivity->linear_iterations()),
                       "iterations of the linear solver for sensitivities");
    recorder.statistic("sensitivity_matrix_seconds", s.assembly_seconds + s.factor_seconds,
                       "wall-clock time in the matrices of sensitivities [s]");
  }
  record_statistics(since_the_start(integrator->statistics(), recorder.restart()), dynamics.audit().at(last), recorder);
  return end;
}

}  // namespace sundrape

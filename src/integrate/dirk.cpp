#include <cmath>

#include <arkode/arkode_arkstep.h>
#include <fmt/format.h>

#include "dirk_tables.hpp"
#include "hermite_step.hpp"
#include "newton_iteration.hpp"
#include "sundials_integrator.hpp"

namespace sundrape {
namespace {

using sundials::require_success;

// Newton's error of a stage, as a part of the error that a step may have.
constexpr double newton_part = 0.1;
// A stage lies further from what is known than a step of the BDF: with ARKODE's 3 it fails half as often again.
constexpr int most_iterations = 5;
// ARKODE's own interpolant, of degree order − 1 at the most, serves its root finder alone; from 4 on it asks for
// forces.
constexpr int root_finding_degree = 3;
constexpr int most_halvings = 20;  // of a fixed step

class Dirk final : public ImplicitIntegrator {
 public:
  Dirk(const System& system, std::unique_ptr<LinearSolver> solver, const IntegratorOptions& options,
       EventSource* events)
      : ImplicitIntegrator(system, std::move(solver), options, events),
        table_(dirk_table(options.max_order)),
        iteration_(y_, context_),
        embedded_([this](N_Vector x, N_Vector b) { return carrier_.run([&] { return solve_newton(x, b); }); },
                  context_),
        end_(form_.size(), context_) {
    require_mass("the diagonally implicit Runge–Kutta method");
  }

  void start(double time, ConstVectorRef q, ConstVectorRef v) override {
    load(time, q, v);
    newton_.forget();
    Vector rates(form_.size());
    if (!form_.rates(time, y_.values(), rates))
      throw IntegrationFailure(fmt::format("the forces are not finite at t = {:.6g} s", time));
    last_.start_from({time, y_.values(), std::move(rates)});
    recorded_steps_ = 0;
    if (memory_) {
      bank();
      require_success(ARKStepReInit(memory_.get(), nullptr, right_side, time, y_.get()), "ARKStepReInit");
    } else {
      weights_.start = q;
      create(time);
    }
    if (is_fixed())
      require_success(ARKStepSetFixedStep(memory_.get(), options_.fixed_step), "ARKStepSetFixedStep");
    else
      require_success(ARKStepSetInitStep(memory_.get(), first_step()), "ARKStepSetInitStep");
  }

  StepReport step(double end) override {
    require_success(ARKStepSetStopTime(memory_.get(), end), "ARKStepSetStopTime");
    const int flag = is_fixed() ? evolve_fixed(end) : evolve(end);
    carrier_.rethrow();
    if (flag < 0) throw IntegrationFailure(diagnosis(flag));
    StepReport report{.time = time_, .order = table_.order, .event = flag == ARK_ROOT_RETURN};
    ARKStepGetLastStep(memory_.get(), &report.step_size);
    last_step_ = report.step_size;
    record_step();
    if (report.event) last_.interpolate(time_, y_.values());
    guard_.start_from(time_, y_.values().head(form_.size() / 2));
    return report;
  }

 private:
  struct Free {
    void operator()(void* memory) const { ARKStepFree(&memory); }
  };

  static Dirk& self(void* data) { return *static_cast<Dirk*>(data); }
  [[nodiscard]] bool is_fixed() const { return options_.fixed_step > 0; }

  static int right_side(realtype t, N_Vector y, N_Vector y_dot, void* data) {
    auto& me = self(data);
    return me.carrier_.run([&] { return me.rates(t, sundials::values(y), sundials::values(y_dot)) ? 0 : 1; });
  }

  void create(double time) {
    memory_.reset(ARKStepCreate(nullptr, right_side, time, y_.get(), context_));
    auto* m = memory_.get();
    if (!m) throw std::bad_alloc();
    require_success(ARKStepSetErrHandlerFn(m, sundials::MessageKeeper::handle, &messages_), "ARKStepSetErrHandlerFn");
    require_success(ARKStepSetTableNum(m, table_.id, ARKODE_ERK_NONE), "ARKStepSetTableNum");
    require_success(ARKStepSetUserData(m, this), "ARKStepSetUserData");
    const auto weigh = [](N_Vector y, N_Vector w, void* data) { return self(data).evaluate_weights(y, w); };
    require_success(ARKStepWFtolerances(m, weigh), "ARKStepWFtolerances");
    require_success(ARKStepSetLinearSolver(m, embedded_.get(), nullptr), "ARKStepSetLinearSolver");
    require_success(ARKStepSetNonlinearSolver(m, iteration_.get()), "ARKStepSetNonlinearSolver");
    iteration_.use_rule(options_.newton_accuracy < 1,
                        [this](N_Vector total, N_Vector last) { return judge_end(total, last); });
    require_success(ARKStepSetNonlinConvCoef(m, options_.newton_accuracy * newton_part), "ARKStepSetNonlinConvCoef");
    // f of a stage that is right to Newton's tolerance is wrong by the stiffest frequency times as much; what the
    // stage's equation says of it is not
    require_success(ARKStepSetDeduceImplicitRhs(m, SUNTRUE), "ARKStepSetDeduceImplicitRhs");
    const auto predict = [](realtype t, N_Vector y, void* data) {
      self(data).last_.extrapolate(t, sundials::values(y));
      return 0;
    };
    require_success(ARKStepSetStagePredictFn(m, predict), "ARKStepSetStagePredictFn");
    require_success(ARKStepSetMaxNonlinIters(m, most_iterations), "ARKStepSetMaxNonlinIters");
    require_success(ARKStepSetInterpolantDegree(m, root_finding_degree), "ARKStepSetInterpolantDegree");
    require_success(ARKStepSetMaxNumSteps(m, -1), "ARKStepSetMaxNumSteps");
    require_success(ARKStepSetMaxConvFails(m, 20), "ARKStepSetMaxConvFails");
    require_success(ARKStepSetMaxErrTestFails(m, 20), "ARKStepSetMaxErrTestFails");
    if (!is_fixed()) {
      require_success(ARKStepSetMinStep(m, least_step), "ARKStepSetMinStep");
      if (options_.max_step) require_success(ARKStepSetMaxStep(m, *options_.max_step), "ARKStepSetMaxStep");
    }
    if (event_count() > 0) {
      const auto roots = [](realtype t, N_Vector y, realtype* values, void* data) {
        return self(data).evaluate_events(t, y, values);
      };
      require_success(ARKStepRootInit(m, event_count(), roots), "ARKStepRootInit");
      require_success(ARKStepSetRootDirection(m, falling().data()), "ARKStepSetRootDirection");
      ARKStepSetNoInactiveRootWarn(m);
    }
  }

  int evolve(double end) { return ARKStepEvolve(memory_.get(), end, y_.get(), &time_, ARK_ONE_STEP); }

  /// ARKODE gives a fixed step up where Newton's iteration fails; halves of it are tried for that one.
  int evolve_fixed(double end) {
    const Vector before = y_.values();
    const double from = time_;
    int flag = evolve(end);
    bool halved = false;
    for (int halvings = 1; flag < 0 && halvings <= most_halvings; ++halvings) {
      halved = true;
      time_ = from;
      y_.values() = before;
      require_success(ARKStepReset(memory_.get(), from, y_.get()), "ARKStepReset");
      require_success(ARKStepSetFixedStep(memory_.get(), std::ldexp(options_.fixed_step, -halvings)),
                      "ARKStepSetFixedStep");
      require_success(ARKStepSetStopTime(memory_.get(), end), "ARKStepSetStopTime");
      flag = evolve(end);
    }
    if (halved && flag >= 0)
      require_success(ARKStepSetFixedStep(memory_.get(), options_.fixed_step), "ARKStepSetFixedStep");
    return flag;
  }

  /// ẏ; at the end of the last step that which its last stage's equation says, for the next one's first.
  bool rates(double t, ConstVectorRef y, VectorRef y_dot) {
    const auto& end = last_.end();
    if (t == end.time && y == end.y) {
      y_dot = end.rates;
      return true;
    }
    return form_.rates(t, y, y_dot);
  }

  /// A step within which an event happens ends beyond it, and is recorded but once.
  void record_step() {
    long steps = 0;
    ARKStepGetNumSteps(memory_.get(), &steps);
    if (steps == recorded_steps_) return;
    recorded_steps_ = steps;
    double end = 0;
    ARKStepGetCurrentTime(memory_.get(), &end);
    require_success(ARKStepGetDky(memory_.get(), end, 0, end_.get()), "ARKStepGetDky");
    last_.advance(end, end_.values(), sundials::values(solved_stage().rates));
  }

  struct Stage {
    realtype time = 0, gamma = 0;
    N_Vector predicted = nullptr, state = nullptr, rates = nullptr;
  };
  [[nodiscard]] Stage solved_stage() const {
    Stage s;
    N_Vector known = nullptr;
    void* data = nullptr;
    require_success(ARKStepGetNonlinearSystemData(memory_.get(), &s.time, &s.predicted, &s.state, &s.rates, &s.gamma,
                                                  &known, &data),
                    "ARKStepGetNonlinearSystemData");
    return s;
  }

  /// (I − γ J) x = b as for CVODE.
  int solve_newton(N_Vector x, N_Vector b) {
    const auto stage = solved_stage();
    const auto n = form_.size() / 2;
    const auto& mass = form_.system().row_mass();
    force_ = sundials::values(stage.rates).tail(n);  // ARKODE has just evaluated ẏ there
    for (int r = 0; r < mass.size(); ++r) point(force_, r) *= mass[r];
    r_q_ = sundials::values(b).head(n) / stage.gamma;
    r_v_ = sundials::values(b).tail(n) / stage.gamma;
    for (int r = 0; r < mass.size(); ++r) point(r_v_, r) *= mass[r];
    return correct(stage.time, 1 / stage.gamma, stage.state, force_, r_q_, r_v_, x);
  }

  sundials::Verdict judge_end(N_Vector total, N_Vector last) {
    const auto stage = solved_stage();
    return judge(stage.time, stage.predicted, total, last);
  }

  void interpolant(double time, N_Vector y) const override { last_.interpolate(time, sundials::values(y)); }
  void root_info(int* fired) const override { ARKStepGetRootInfo(memory_.get(), fired); }

  [[nodiscard]] IntegratorStatistics current() const override {
    IntegratorStatistics s;
    auto* m = memory_.get();
    ARKStepGetNumSteps(m, &s.steps);
    ARKStepGetNumNonlinSolvIters(m, &s.newton_iterations);
    ARKStepGetNumErrTestFails(m, &s.error_test_failures);
    ARKStepGetNumStepSolveFails(m, &s.step_solve_failures);
    return with_linear(s);
  }

  [[nodiscard]] std::string diagnosis(int flag) const {
    realtype h = 0;
    ARKStepGetCurrentStep(memory_.get(), &h);
    std::string what = "ARKODE's DIRK method cannot go on";
    std::string advice = "try more strain-rate damping, a softer contact or a finer mesh";
    if (flag == ARK_CONV_FAILURE) what = cause("Newton's iteration does not converge, however small the step");
    if (flag == ARK_ERR_FAILURE) {
      what = "the error test fails, however small the step";
      advice = "try a looser rtol or more strain-rate damping";
    }
    if (flag == ARK_FIRST_RHSFUNC_ERR || flag == ARK_REPTD_RHSFUNC_ERR || flag == ARK_UNREC_RHSFUNC_ERR)
      what = "the forces are not finite: nodes coincide, or the motion has blown up";
    return fmt::format("{} at t = {:.6g} s, step {:.3g} s; {} ({})", what, time_, h, advice, messages_.last);
  }

  DirkTable table_;
  sundials::NewtonIteration iteration_;
  sundials::EmbeddedSolver embedded_;
  std::unique_ptr<void, Free> memory_;
  Vector force_, r_q_, r_v_;
  sundials::StateVector end_;
  HermiteStep last_;
  long recorded_steps_ = 0;
};

}  // namespace

std::unique_ptr<Integrator> make_dirk(const System& system, std::unique_ptr<LinearSolver> solver,
                                      const IntegratorOptions& options, EventSource* events) {
  return std::make_unique<Dirk>(system, std::move(solver), options, events);
}

}  // namespace sundrape

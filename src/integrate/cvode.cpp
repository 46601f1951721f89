#include <cvode/cvode.h>
#include <fmt/format.h>

#include "newton_iteration.hpp"
#include "sundials_integrator.hpp"

namespace sundrape {
namespace {

using sundials::require_success;

// Newton's error as a part of the step's own. CVODE's 0.1 now and then takes a first iterate that costs failures later.
constexpr double newton_part = 0.07;
constexpr double nothing_is_small = 1e-12;  // part of the step's own error that a residual unsolved for may be

class Cvode final : public ImplicitIntegrator {
 public:
  Cvode(const System& system, std::unique_ptr<LinearSolver> solver, const IntegratorOptions& options,
        EventSource* events)
      : ImplicitIntegrator(system, std::move(solver), options, events),
        iteration_(y_, context_),
        embedded_([this](N_Vector x, N_Vector b) { return carrier_.run([&] { return solve_newton(x, b); }); },
                  context_) {
    require_mass("CVODE");
  }

  void start(double time, ConstVectorRef q, ConstVectorRef v) override {
    load(time, q, v);
    newton_.forget();
    if (memory_) {
      bank();
      require_success(CVodeReInit(memory_.get(), time, y_.get()), "CVodeReInit");
    } else {
      weights_.start = q;
      create(time);
    }
    require_success(CVodeSetInitStep(memory_.get(), first_step()), "CVodeSetInitStep");
  }

  StepReport step(double end) override {
    require_success(CVodeSetStopTime(memory_.get(), end), "CVodeSetStopTime");
    const int flag = CVode(memory_.get(), end, y_.get(), &time_, CV_ONE_STEP);
    carrier_.rethrow();
    if (flag < 0) throw IntegrationFailure(diagnosis(flag));
    StepReport report{.time = time_, .event = flag == CV_ROOT_RETURN};
    CVodeGetLastStep(memory_.get(), &report.step_size);
    CVodeGetLastOrder(memory_.get(), &report.order);
    last_step_ = report.step_size;
    guard_.start_from(time_, y_.values().head(form_.size() / 2));
    return report;
  }

 private:
  struct Free {
    void operator()(void* memory) const { CVodeFree(&memory); }
  };

  static Cvode& self(void* data) { return *static_cast<Cvode*>(data); }

  void create(double time) {
    memory_.reset(CVodeCreate(CV_BDF, context_));
    auto* m = memory_.get();
    if (!m) throw std::bad_alloc();
    require_success(CVodeSetErrHandlerFn(m, sundials::MessageKeeper::handle, &messages_), "CVodeSetErrHandlerFn");
    require_success(CVodeSetMaxOrd(m, options_.max_order), "CVodeSetMaxOrd");
    const auto right_side = [](realtype t, N_Vector y, N_Vector y_dot, void* data) {
      auto& me = self(data);
      return me.carrier_.run([&] { return me.form_.rates(t, sundials::values(y), sundials::values(y_dot)) ? 0 : 1; });
    };
    require_success(CVodeInit(m, right_side, time, y_.get()), "CVodeInit");
    require_success(CVodeSetUserData(m, this), "CVodeSetUserData");
    const auto weigh = [](N_Vector y, N_Vector w, void* data) { return self(data).evaluate_weights(y, w); };
    require_success(CVodeWFtolerances(m, weigh), "CVodeWFtolerances");
    require_success(CVodeSetLinearSolver(m, embedded_.get(), nullptr), "CVodeSetLinearSolver");
    if (options_.solves_always) require_success(CVodeSetEpsLin(m, nothing_is_small), "CVodeSetEpsLin");
    require_success(CVodeSetNonlinearSolver(m, iteration_.get()), "CVodeSetNonlinearSolver");
    iteration_.use_rule(options_.newton_accuracy < 1,
                        [this](N_Vector total, N_Vector last) { return judge_end(total, last); });
    require_success(CVodeSetNonlinConvCoef(m, options_.newton_accuracy * newton_part), "CVodeSetNonlinConvCoef");
    require_success(CVodeSetMaxNumSteps(m, -1), "CVodeSetMaxNumSteps");
    require_success(CVodeSetMinStep(m, least_step), "CVodeSetMinStep");
    require_success(CVodeSetMaxConvFails(m, 20), "CVodeSetMaxConvFails");
    require_success(CVodeSetMaxErrTestFails(m, 20), "CVodeSetMaxErrTestFails");
    if (options_.max_step) require_success(CVodeSetMaxStep(m, *options_.max_step), "CVodeSetMaxStep");
    if (event_count() > 0) {
      const auto roots = [](realtype t, N_Vector y, realtype* values, void* data) {
        return self(data).evaluate_events(t, y, values);
      };
      require_success(CVodeRootInit(m, event_count(), roots), "CVodeRootInit");
      require_success(CVodeSetRootDirection(m, falling().data()), "CVodeSetRootDirection");
      CVodeSetNoInactiveRootWarn(m);
    }
  }

  /// (I − γ J) x = b: multiplied by 1/γ, and the second half by M, it is the condensed system with r_q = b_q/γ, r_v = M
  /// b_v/γ.
  int solve_newton(N_Vector x, N_Vector b) {
    realtype t = 0, gamma = 0, rl1 = 0;
    N_Vector predicted = nullptr, y = nullptr, f = nullptr, zn1 = nullptr;
    void* data = nullptr;
    require_success(CVodeGetNonlinearSystemData(memory_.get(), &t, &predicted, &y, &f, &gamma, &rl1, &zn1, &data),
                    "CVodeGetNonlinearSystemData");
    const auto n = form_.size() / 2;
    const auto& mass = form_.system().row_mass();
    force_ = sundials::values(f).tail(n);  // CVODE has just evaluated ẏ there
    for (int r = 0; r < mass.size(); ++r) point(force_, r) *= mass[r];
    r_q_ = sundials::values(b).head(n) / gamma;
    r_v_ = sundials::values(b).tail(n) / gamma;
    for (int r = 0; r < mass.size(); ++r) point(r_v_, r) *= mass[r];
    return correct(t, 1 / gamma, y, force_, r_q_, r_v_, x);
  }

  sundials::Verdict judge_end(N_Vector total, N_Vector last) {
    realtype t = 0, gamma = 0, rl1 = 0;
    N_Vector predicted = nullptr, y = nullptr, f = nullptr, zn1 = nullptr;
    void* data = nullptr;
    CVodeGetNonlinearSystemData(memory_.get(), &t, &predicted, &y, &f, &gamma, &rl1, &zn1, &data);
    return judge(t, predicted, total, last);
  }

  void interpolant(double time, N_Vector y) const override {
    require_success(CVodeGetDky(memory_.get(), time, 0, y), "CVodeGetDky");
  }
  void root_info(int* fired) const override { CVodeGetRootInfo(memory_.get(), fired); }

  [[nodiscard]] IntegratorStatistics current() const override {
    IntegratorStatistics s;
    auto* m = memory_.get();
    CVodeGetNumSteps(m, &s.steps);
    CVodeGetNumNonlinSolvIters(m, &s.newton_iterations);
    CVodeGetNumErrTestFails(m, &s.error_test_failures);
    CVodeGetNumStepSolveFails(m, &s.step_solve_failures);
    return with_linear(s);
  }

  [[nodiscard]] std::string diagnosis(int flag) const {
    realtype h = 0;
    CVodeGetCurrentStep(memory_.get(), &h);
    std::string what = "CVODE cannot go on";
    std::string advice = "try more strain-rate damping, a softer contact or a finer mesh";
    if (flag == CV_CONV_FAILURE) what = cause("Newton's iteration does not converge, however small the step");
    if (flag == CV_ERR_FAILURE) {
      what = "the error test fails, however small the step";
      advice = "try a looser rtol or more strain-rate damping";
    }
    if (flag == CV_FIRST_RHSFUNC_ERR || flag == CV_REPTD_RHSFUNC_ERR || flag == CV_UNREC_RHSFUNC_ERR)
      what = "the forces are not finite: nodes coincide, or the motion has blown up";
    return fmt::format("{} at t = {:.6g} s, step {:.3g} s; {} ({})", what, time_, h, advice, messages_.last);
  }

  sundials::NewtonIteration iteration_;
  sundials::EmbeddedSolver embedded_;
  std::unique_ptr<void, Free> memory_;
  Vector force_, r_q_, r_v_;
};

}  // namespace

std::unique_ptr<Integrator> make_cvode(const System& system, std::unique_ptr<LinearSolver> solver,
                                       const IntegratorOptions& options, EventSource* events) {
  return std::make_unique<Cvode>(system, std::move(solver), options, events);
}

}  // namespace sundrape

#include <cvode/cvode.h>
#include <fmt/format.h>

#include "sundrape/integrate/first_order_form.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/integrate/sundials_support.hpp"

namespace sundrape {
namespace {

using sundials::require_success;

class Cvode final : public Integrator {
 public:
  Cvode(const System& system, std::unique_ptr<LinearSolver> solver, const IntegratorOptions& options, EventSource* events)
      : form_(system),
        newton_(system, std::move(solver), options.linear_tolerance),
        weights_{options.rtol, options.atol_position, options.atol_velocity, Vector::Zero(system.unknowns().size())},
        options_(options),
        events_(events),
        y_(form_.size(), context_),
        embedded_([this](N_Vector x, N_Vector b) { return carrier_.run([&] { return solve(x, b); }); }, context_) {}

  void start(double time, ConstVectorRef q, ConstVectorRef v) override {
    const auto n = q.size();
    auto y = y_.values();
    y.head(n) = q;
    y.tail(n) = v;
    time_ = time;
    matrix_time_ = matrix_gamma_ = -1;
    if (memory_) {
      bank();
      require_success(CVodeReInit(memory_.get(), time, y_.get()), "CVodeReInit");
      ++banked_.restarts;
    } else {
      weights_.start = q;
      create(time);
    }
    // Restarts begin with the last step's size, which the problem was smooth enough for; CVODE checks it anyway.
    const double first = last_step_ > 0 ? 0.1 * last_step_ : options_.first_step.value_or(0.0);
    require_success(CVodeSetInitStep(memory_.get(), first), "CVodeSetInitStep");
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
    return report;
  }

  void state(VectorRef q, VectorRef v) const override {
    q = y_.values().head(q.size());
    v = y_.values().tail(v.size());
  }

  void interpolate(double time, VectorRef q, VectorRef v) const override {
    const sundials::StateVector at(form_.size(), context_);
    require_success(CVodeGetDky(memory_.get(), time, 0, at.get()), "CVodeGetDky");
    q = at.values().head(q.size());
    v = at.values().tail(v.size());
  }

  [[nodiscard]] std::vector<int> fired() const override {
    std::vector<int> roots(static_cast<std::size_t>(events_ ? events_->count() : 0));
    if (!roots.empty()) CVodeGetRootInfo(memory_.get(), roots.data());
    return roots;
  }

  [[nodiscard]] IntegratorStatistics statistics() const override {
    auto s = current();
    s.steps += banked_.steps;
    s.newton_iterations += banked_.newton_iterations;
    s.error_test_failures += banked_.error_test_failures;
    s.step_solve_failures += banked_.step_solve_failures;
    s.restarts = banked_.restarts;
    s.force_evaluations = form_.evaluations();
    s.linear = newton_.counters();
    return s;
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
    const auto weigh = [](N_Vector y, N_Vector w, void* data) {
      auto& me = self(data);
      return me.carrier_.run([&] {
        me.weights_.evaluate(sundials::values(y), sundials::values(w));
        return 0;
      });
    };
    require_success(CVodeWFtolerances(m, weigh), "CVodeWFtolerances");
    require_success(CVodeSetLinearSolver(m, embedded_.get(), nullptr), "CVodeSetLinearSolver");
    require_success(CVodeSetMaxNumSteps(m, -1), "CVodeSetMaxNumSteps");
    require_success(CVodeSetMaxConvFails(m, 20), "CVodeSetMaxConvFails");
    require_success(CVodeSetMaxErrTestFails(m, 20), "CVodeSetMaxErrTestFails");
    if (options_.max_step) require_success(CVodeSetMaxStep(m, *options_.max_step), "CVodeSetMaxStep");
    if (events_ && events_->count() > 0) {
      const auto roots = [](realtype t, N_Vector y, realtype* values, void* data) {
        auto& me = self(data);
        return me.carrier_.run([&] {
          me.form_.events(t, sundials::values(y), *me.events_, {values, static_cast<std::size_t>(me.events_->count())});
          return 0;
        });
      };
      require_success(CVodeRootInit(m, events_->count(), roots), "CVodeRootInit");
      std::vector<int> falling(static_cast<std::size_t>(events_->count()), -1);
      require_success(CVodeSetRootDirection(m, falling.data()), "CVodeSetRootDirection");
      CVodeSetNoInactiveRootWarn(m);
    }
  }

  /// (I − γ J) x = b: multiplied by 1/γ, and the second half by M, it is the condensed system with r_q = b_q/γ, r_v = M b_v/γ.
  int solve(N_Vector x, N_Vector b) {
    realtype t = 0, gamma = 0, rl1 = 0;
    N_Vector predicted = nullptr, y = nullptr, f = nullptr, zn1 = nullptr;
    void* data = nullptr;
    require_success(CVodeGetNonlinearSystemData(memory_.get(), &t, &predicted, &y, &f, &gamma, &rl1, &zn1, &data), "CVodeGetNonlinearSystemData");
    const auto n = form_.size() / 2;
    if (t != matrix_time_ || gamma != matrix_gamma_) {   // a new step or a new try of one: refresh
      matrix_time_ = matrix_gamma_ = -1;
      const auto at = sundials::values(y);
      if (newton_.prepare(t, 1 / gamma, at.head(n), at.tail(n)) != FactorStatus::ok) return SUNLS_PACKAGE_FAIL_REC;
      matrix_time_ = t;
      matrix_gamma_ = gamma;
    }
    r_q_ = sundials::values(b).head(n) / gamma;
    r_v_ = sundials::values(b).tail(n) / gamma;
    for (int r = 0; r < form_.system().unknowns().rows(); ++r) point(r_v_, r) *= form_.system().row_mass()[r];
    auto result = sundials::values(x);
    return newton_.solve(r_q_, r_v_, result.head(n), result.tail(n)).ok ? 0 : SUNLS_PACKAGE_FAIL_REC;
  }

  [[nodiscard]] IntegratorStatistics current() const {
    IntegratorStatistics s;
    auto* m = memory_.get();
    CVodeGetNumSteps(m, &s.steps);
    CVodeGetNumNonlinSolvIters(m, &s.newton_iterations);
    CVodeGetNumErrTestFails(m, &s.error_test_failures);
    CVodeGetNumStepSolveFails(m, &s.step_solve_failures);
    return s;
  }

  void bank() {   // CVodeReInit sets the counters back
    const auto s = current();
    banked_.steps += s.steps;
    banked_.newton_iterations += s.newton_iterations;
    banked_.error_test_failures += s.error_test_failures;
    banked_.step_solve_failures += s.step_solve_failures;
  }

  [[nodiscard]] std::string diagnosis(int flag) const {
    realtype h = 0;
    CVodeGetCurrentStep(memory_.get(), &h);
    std::string what = "CVODE cannot go on";
    std::string advice = "try more strain-rate damping, a softer contact or a finer mesh";
    if (flag == CV_CONV_FAILURE) what = "Newton's iteration does not converge, however small the step";
    if (flag == CV_ERR_FAILURE) {
      what = "the error test fails, however small the step";
      advice = "try a looser rtol or more strain-rate damping";
    }
    if (flag == CV_FIRST_RHSFUNC_ERR || flag == CV_REPTD_RHSFUNC_ERR || flag == CV_UNREC_RHSFUNC_ERR)
      what = "the forces are not finite: nodes coincide, or the motion has blown up";
    return fmt::format("{} at t = {:.6g} s, step {:.3g} s; {} ({})", what, time_, h, advice, messages_.last);
  }

  sundials::Context context_;
  sundials::ExceptionCarrier carrier_;
  sundials::MessageKeeper messages_;
  FirstOrderForm form_;
  CondensedNewton newton_;
  ErrorWeights weights_;
  IntegratorOptions options_;
  EventSource* events_;
  sundials::StateVector y_;
  sundials::EmbeddedSolver embedded_;
  std::unique_ptr<void, Free> memory_;
  Vector r_q_, r_v_;
  double time_ = 0, matrix_time_ = -1, matrix_gamma_ = -1, last_step_ = 0;
  IntegratorStatistics banked_;
};

}  // namespace

std::unique_ptr<Integrator> make_cvode(const System& system, std::unique_ptr<LinearSolver> solver, const IntegratorOptions& options, EventSource* events) {
  return std::make_unique<Cvode>(system, std::move(solver), options, events);
}

}  // namespace sundrape

#include <fmt/format.h>
#include <ida/ida.h>

#include "newton_iteration.hpp"
#include "sundials_integrator.hpp"

namespace sundrape {
namespace {

using sundials::require_success;

constexpr double newton_part = 0.1;  // Newton's error in the weighted norm; IDA's 0.33 lets nodes sink into obstacles

class Ida final : public ImplicitIntegrator {
 public:
  Ida(const System& system, std::unique_ptr<LinearSolver> solver, const IntegratorOptions& options, EventSource* events)
      : ImplicitIntegrator(system, std::move(solver), options, events),
        y_dot_(form_.size(), context_),
        iteration_(y_, context_),
        embedded_([this](N_Vector x, N_Vector b) { return carrier_.run([&] { return solve_newton(x, b); }); },
                  context_) {}

  void start(double time, ConstVectorRef q, ConstVectorRef v) override {
    load(time, q, v);
    newton_.forget();
    if (!form_.rates(time, y_.values(), y_dot_.values()))
      throw IntegrationFailure(fmt::format("the forces are not finite at t = {:.6g} s", time));
    if (memory_) {
      bank();
      require_success(IDAReInit(memory_.get(), time, y_.get(), y_dot_.get()), "IDAReInit");
    } else {
      weights_.start = q;
      create(time);
    }
    require_success(IDASetInitStep(memory_.get(), first_step()), "IDASetInitStep");
  }

  StepReport step(double end) override {
    require_success(IDASetStopTime(memory_.get(), end), "IDASetStopTime");
    const int flag = IDASolve(memory_.get(), end, &time_, y_.get(), y_dot_.get(), IDA_ONE_STEP);
    carrier_.rethrow();
    if (flag < 0) throw IntegrationFailure(diagnosis(flag));
    StepReport report{.time = time_, .event = flag == IDA_ROOT_RETURN};
    IDAGetLastStep(memory_.get(), &report.step_size);
    IDAGetLastOrder(memory_.get(), &report.order);
    last_step_ = report.step_size;
    guard_.start_from(time_, y_.values().head(form_.size() / 2));
    return report;
  }

 private:
  struct Free {
    void operator()(void* memory) const { IDAFree(&memory); }
  };

  static Ida& self(void* data) { return *static_cast<Ida*>(data); }

  void create(double time) {
    memory_.reset(IDACreate(context_));
    auto* m = memory_.get();
    if (!m) throw std::bad_alloc();
    require_success(IDASetErrHandlerFn(m, sundials::MessageKeeper::handle, &messages_), "IDASetErrHandlerFn");
    require_success(IDASetMaxOrd(m, options_.max_order), "IDASetMaxOrd");
    const auto residual = [](realtype t, N_Vector y, N_Vector y_dot, N_Vector r, void* data) {
      auto& me = self(data);
      return me.carrier_.run(
          [&] { return me.residual(t, sundials::values(y), sundials::values(y_dot), sundials::values(r)); });
    };
    require_success(IDAInit(m, residual, time, y_.get(), y_dot_.get()), "IDAInit");
    require_success(IDASetUserData(m, this), "IDASetUserData");
    const auto weigh = [](N_Vector y, N_Vector w, void* data) { return self(data).evaluate_weights(y, w); };
    require_success(IDAWFtolerances(m, weigh), "IDAWFtolerances");
    if (form_.system().has_massless_rows()) leave_algebraic_rates_out_of_the_error_test();
    require_success(IDASetLinearSolver(m, embedded_.get(), nullptr), "IDASetLinearSolver");
    require_success(IDASetNonlinearSolver(m, iteration_.get()), "IDASetNonlinearSolver");
    iteration_.use_rule(options_.newton_accuracy < 1,
                        [this](N_Vector total, N_Vector last) { return judge_end(total, last); });
    require_success(IDASetNonlinConvCoef(m, options_.newton_accuracy * newton_part), "IDASetNonlinConvCoef");
    require_success(IDASetMaxNumSteps(m, -1), "IDASetMaxNumSteps");
    require_success(IDASetMinStep(m, least_step), "IDASetMinStep");
    require_success(IDASetMaxConvFails(m, 20), "IDASetMaxConvFails");
    require_success(IDASetMaxErrTestFails(m, 20), "IDASetMaxErrTestFails");
    if (options_.max_step) require_success(IDASetMaxStep(m, *options_.max_step), "IDASetMaxStep");
    if (event_count() > 0) {
      const auto roots = [](realtype t, N_Vector y, N_Vector, realtype* values, void* data) {
        return self(data).evaluate_events(t, y, values);
      };
      require_success(IDARootInit(m, event_count(), roots), "IDARootInit");
      require_success(IDASetRootDirection(m, falling().data()), "IDASetRootDirection");
      IDASetNoInactiveRootWarn(m);
    }
  }

  /// The rates of points without mass follow from their forces at each instant: damping makes them index 1.
  void leave_algebraic_rates_out_of_the_error_test() {
    const sundials::StateVector differential(form_.size(), context_);
    auto id = differential.values();
    id.setOnes();
    const auto& mass = form_.system().row_mass();
    for (int row = 0; row < mass.size(); ++row)
      if (mass[row] == 0) id.segment<3>(form_.size() / 2 + 3 * row).setZero();
    require_success(IDASetId(memory_.get(), differential.get()), "IDASetId");
    require_success(IDASetSuppressAlg(memory_.get(), SUNTRUE), "IDASetSuppressAlg");
  }

  /// r = (q̇ − v, M v̇ − f)
  int residual(double t, ConstVectorRef y, ConstVectorRef y_dot, VectorRef r) {
    const auto n = form_.size() / 2;
    if (!form_.forces(t, y, r.tail(n))) return 1;
    r.head(n) = y_dot.head(n) - y.tail(n);
    for (int row = 0; row < form_.system().unknowns().rows(); ++row)
      r.segment<3>(n + 3 * row) =
          form_.system().row_mass()[row] * y_dot.segment<3>(n + 3 * row) - r.segment<3>(n + 3 * row);
    for (const auto& [row, component] : form_.system().unknowns().held_components())
      r[n + 3 * row + component] = y_dot[n + 3 * row + component];
    return 0;
  }

  int solve_newton(N_Vector x, N_Vector b) {
    realtype t = 0, c = 0;
    N_Vector predicted = nullptr, predicted_dot = nullptr, y = nullptr, y_dot = nullptr, r = nullptr;
    void* data = nullptr;
    require_success(IDAGetNonlinearSystemData(memory_.get(), &t, &predicted, &predicted_dot, &y, &y_dot, &r, &c, &data),
                    "IDAGetNonlinearSystemData");
    const auto n = form_.size() / 2;
    const auto& mass = form_.system().row_mass();
    force_ = -sundials::values(r).tail(n);  // IDA has just evaluated r there
    for (int row = 0; row < mass.size(); ++row)
      point(force_, row) += mass[row] * sundials::values(y_dot).segment<3>(n + 3 * row);
    const auto right = sundials::values(b);
    return correct(t, c, y, force_, right.head(n), right.tail(n), x);
  }

  sundials::Verdict judge_end(N_Vector total, N_Vector last) {
    realtype t = 0, c = 0;
    N_Vector predicted = nullptr, predicted_dot = nullptr, y = nullptr, y_dot = nullptr, r = nullptr;
    void* data = nullptr;
    IDAGetNonlinearSystemData(memory_.get(), &t, &predicted, &predicted_dot, &y, &y_dot, &r, &c, &data);
    return judge(t, predicted, total, last);
  }

  void interpolant(double time, N_Vector y) const override {
    require_success(IDAGetDky(memory_.get(), time, 0, y), "IDAGetDky");
  }
  void root_info(int* fired) const override { IDAGetRootInfo(memory_.get(), fired); }

  [[nodiscard]] IntegratorStatistics current() const override {
    IntegratorStatistics s;
    auto* m = memory_.get();
    IDAGetNumSteps(m, &s.steps);
    IDAGetNumNonlinSolvIters(m, &s.newton_iterations);
    IDAGetNumErrTestFails(m, &s.error_test_failures);
    IDAGetNumStepSolveFails(m, &s.step_solve_failures);
    return with_linear(s);
  }

  [[nodiscard]] std::string diagnosis(int flag) const {
    realtype h = 0;
    IDAGetCurrentStep(memory_.get(), &h);
    std::string what = "IDA cannot go on";
    std::string advice = "try more strain-rate damping, a softer contact or a finer mesh";
    if (flag == IDA_CONV_FAIL || flag == IDA_LSOLVE_FAIL)
      what = cause("Newton's iteration does not converge, however small the step");
    if (flag == IDA_ERR_FAIL) {
      what = "the error test fails, however small the step";
      advice = "try a looser rtol or more strain-rate damping";
    }
    if (!guard_.refusal() && form_.system().has_massless_rows() &&
        (flag == IDA_CONV_FAIL || flag == IDA_LSOLVE_FAIL || flag == IDA_ERR_FAIL)) {
      what =
          "the equations of directors without inertia have turned singular, as they do where a fold is sharper than "
          "the mesh";
      advice = "try shell.director = \"inertia\", more material.damping.bending or a finer mesh";
    }
    if (flag == IDA_REP_RES_ERR || flag == IDA_RES_FAIL || flag == IDA_FIRST_RES_FAIL)
      what = "the forces are not finite: nodes coincide, or the motion has blown up";
    return fmt::format("{} at t = {:.6g} s, step {:.3g} s; {} ({})", what, time_, h, advice, messages_.last);
  }

  sundials::StateVector y_dot_;
  sundials::NewtonIteration iteration_;
  sundials::EmbeddedSolver embedded_;
  std::unique_ptr<void, Free> memory_;
  Vector force_;
};

}  // namespace

std::unique_ptr<Integrator> make_ida(const System& system, std::unique_ptr<LinearSolver> solver,
                                     const IntegratorOptions& options, EventSource* events) {
  return std::make_unique<Ida>(system, std::move(solver), options, events);
}

}  // namespace sundrape

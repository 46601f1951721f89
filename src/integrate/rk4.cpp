#include <array>
#include <cmath>

#include <arkode/arkode_erkstep.h>
#include <fmt/format.h>

#include "sundials_integrator.hpp"

namespace sundrape {
namespace {

using sundials::require_success;

class RungeKutta4 final : public SundialsIntegrator {
 public:
  RungeKutta4(const System& system, const IntegratorOptions& options, EventSource* events)
      : SundialsIntegrator(system, options, events) {
    if (!(options.fixed_step > 0)) throw std::invalid_argument("the Runge–Kutta method needs a positive step [s]");
    require_mass("the Runge–Kutta method");
  }

  void start(double time, ConstVectorRef q, ConstVectorRef v) override {
    load(time, q, v);
    const auto right_side = [](realtype t, N_Vector y_now, N_Vector y_dot, void* data) {
      auto& me = self(data);
      return me.carrier_.run(
          [&] { return me.form_.rates(t, sundials::values(y_now), sundials::values(y_dot)) ? 0 : -1; });
    };
    if (memory_) {
      bank();
      require_success(ERKStepReInit(memory_.get(), right_side, time, y_.get()), "ERKStepReInit");
      return;
    }
    memory_.reset(ERKStepCreate(right_side, time, y_.get(), context_));
    auto* m = memory_.get();
    if (!m) throw std::bad_alloc();
    require_success(ERKStepSetErrHandlerFn(m, sundials::MessageKeeper::handle, &messages_), "ERKStepSetErrHandlerFn");
    require_success(ERKStepSetUserData(m, this), "ERKStepSetUserData");
    set_classical_table();
    // ERKStep 6.4 takes every table for first-same-as-last and reuses the last stage as the next step's first, which
    // costs the classical method an order (SUNDIALS issue 311); with a post-processing step it evaluates anew.
    require_success(ERKStepSetPostprocessStepFn(m, [](realtype, N_Vector, void*) { return 0; }),
                    "ERKStepSetPostprocessStepFn");
    require_success(ERKStepSetFixedStep(m, options_.fixed_step), "ERKStepSetFixedStep");
    require_success(ERKStepSetMaxNumSteps(m, -1), "ERKStepSetMaxNumSteps");
    if (event_count() > 0) {
      const auto roots = [](realtype t, N_Vector y_now, realtype* values, void* data) {
        return self(data).evaluate_events(t, y_now, values);
      };
      require_success(ERKStepRootInit(m, event_count(), roots), "ERKStepRootInit");
      require_success(ERKStepSetRootDirection(m, falling().data()), "ERKStepSetRootDirection");
      ERKStepSetNoInactiveRootWarn(m);
    }
  }

  StepReport step(double end) override {
    require_success(ERKStepSetStopTime(memory_.get(), end), "ERKStepSetStopTime");
    const Vector before = y_.values();
    const double from = time_;
    int flag = ERKStepEvolve(memory_.get(), end, y_.get(), &time_, ARK_ONE_STEP);
    bool halved = false;
    for (int halvings = 1; flag >= 0 && !guard_.admits(time_, y_.values().head(form_.size() / 2)); ++halvings) {
      if (halvings > most_halvings)
        throw IntegrationFailure(
            fmt::format("{}, at t = {:.6g} s, however small the step", describe(*guard_.refusal()), from));
      halved = true;
      y_.values() = before;
      require_success(ERKStepReset(memory_.get(), from, y_.get()), "ERKStepReset");
      require_success(ERKStepSetFixedStep(memory_.get(), std::ldexp(options_.fixed_step, -halvings)),
                      "ERKStepSetFixedStep");
      flag = ERKStepEvolve(memory_.get(), end, y_.get(), &time_, ARK_ONE_STEP);
    }
    if (halved) require_success(ERKStepSetFixedStep(memory_.get(), options_.fixed_step), "ERKStepSetFixedStep");
    carrier_.rethrow();
    const double speed = y_.values().tail(form_.size() / 2).cwiseAbs().maxCoeff();
    if (flag < 0 || !(speed < absurd_speed))
      throw IntegrationFailure(fmt::format(
          "the fixed-step Runge–Kutta method has blown up at t = {:.6g} s with a step of {:.3g} s; the stability limit "
          "reported at the start is an estimate for the initial shape: try a smaller dynamics.step",
          time_, options_.fixed_step));
    StepReport report{.time = time_, .order = 4, .event = flag == ARK_ROOT_RETURN};
    ERKStepGetLastStep(memory_.get(), &report.step_size);
    guard_.start_from(time_, y_.values().head(form_.size() / 2));
    return report;
  }

 private:
  static constexpr int most_halvings = 20;
  static constexpr double absurd_speed = 1e4;  // [m/s]; no cloth survives it
  struct Free {
    void operator()(void* memory) const { ERKStepFree(&memory); }
  };

  static RungeKutta4& self(void* data) { return *static_cast<RungeKutta4*>(data); }

  void interpolant(double time, N_Vector y) const override {
    require_success(ERKStepGetDky(memory_.get(), time, 0, y), "ERKStepGetDky");
  }
  void root_info(int* fired) const override { ERKStepGetRootInfo(memory_.get(), fired); }
  [[nodiscard]] IntegratorStatistics current() const override {
    IntegratorStatistics s;
    ERKStepGetNumSteps(memory_.get(), &s.steps);
    return s;
  }

  void set_classical_table() {
    std::array<double, 4> c{0, 0.5, 0.5, 1}, b{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    std::array<double, 16> a{};
    a[4 * 1 + 0] = a[4 * 2 + 1] = 0.5;
    a[4 * 3 + 2] = 1;
    auto* table = ARKodeButcherTable_Create(4, 4, 0, c.data(), a.data(), b.data(), nullptr);
    const int flag = ERKStepSetTable(memory_.get(), table);
    ARKodeButcherTable_Free(table);
    require_success(flag, "ERKStepSetTable");
  }

  std::unique_ptr<void, Free> memory_;
};

}  // namespace

std::unique_ptr<Integrator> make_rk4(const System& system, const IntegratorOptions& options, EventSource* events) {
  return std::make_unique<RungeKutta4>(system, options, events);
}

}  // namespace sundrape

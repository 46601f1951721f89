#pragma once
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "sundrape/integrate/events.hpp"
#include "sundrape/system/condensed_newton.hpp"

namespace sundrape {

/// An integrator that cannot go on; what() says where and what to try.
class IntegrationFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct IntegratorOptions {
  double rtol = 1e-4;
  double atol_position = 0;  // [m]
  double atol_velocity = 0;  // [m/s]
  Vector rate_slack = {};    // rows, n: how many times larger the errors of rates may be; empty: 1
  int max_order = 2;         // of the BDF; the order of the diagonally implicit Runge–Kutta method
  std::optional<double> first_step{}, max_step{};  // [s]
  double newton_accuracy = 1;                      // factor on the error that Newton's iteration may leave
  double fixed_step = 0;                           // [s], Runge–Kutta only; diagonally implicit: 0 for error control
  double linear_tolerance = 3e-3;                  // of iterative linear solves, relative
  bool solves_always = false;  // CVODE: also where a step's residual, unsolved, would do as its correction
};

struct IntegratorStatistics {
  long steps = 0, force_evaluations = 0, newton_iterations = 0, error_test_failures = 0, step_solve_failures = 0,
       restarts = 0;
  CondensedNewton::Counters linear;
};

/// What one internal step ended with.
struct StepReport {
  double time = 0, step_size = 0;  // [s]
  int order = 0;
  bool event = false;  // stopped at a root of the events, before the step's end
};

/// Advances the unknowns of a system by internal steps of its own choice.
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// (Re)starts from a state of the unknowns (rows, 3n).
  virtual void start(double time, ConstVectorRef q, ConstVectorRef v) = 0;
  /// One internal step, never beyond `end`.
  /// @throws IntegrationFailure
  virtual StepReport step(double end) = 0;
  /// The state after the last step (or event); rows, 3n.
  virtual void state(VectorRef q, VectorRef v) const = 0;
  /// The state at a time within the last step.
  virtual void interpolate(double time, VectorRef q, VectorRef v) const = 0;
  /// After a step that ended with an event: non-zero for the events that happened.
  [[nodiscard]] virtual std::vector<int> fired() const = 0;
  [[nodiscard]] virtual IntegratorStatistics statistics() const = 0;
};

/// CVODE's BDF on ẏ = (v, M⁻¹ f).
[[nodiscard]] std::unique_ptr<Integrator> make_cvode(const System& system, std::unique_ptr<LinearSolver> solver,
                                                     const IntegratorOptions& options, EventSource* events = nullptr);
/// IDA's BDF on the residual (q̇ − v, M v̇ − f).
[[nodiscard]] std::unique_ptr<Integrator> make_ida(const System& system, std::unique_ptr<LinearSolver> solver,
                                                   const IntegratorOptions& options, EventSource* events = nullptr);
/// ARKODE's diagonally implicit Runge–Kutta methods on ẏ = (v, M⁻¹ f), of order 2 to 5 (docs/integrators.md).
[[nodiscard]] std::unique_ptr<Integrator> make_dirk(const System& system, std::unique_ptr<LinearSolver> solver,
                                                    const IntegratorOptions& options, EventSource* events = nullptr);
/// The classical fourth-order Runge–Kutta method with a fixed step (chapter §3.3), through ARKODE.
[[nodiscard]] std::unique_ptr<Integrator> make_rk4(const System& system, const IntegratorOptions& options,
                                                   EventSource* events = nullptr);

}  // namespace sundrape

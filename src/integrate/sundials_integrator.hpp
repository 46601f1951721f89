#pragma once
#include <vector>

#include "sundrape/integrate/error_weights.hpp"
#include "sundrape/integrate/first_order_form.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/integrate/step_guard.hpp"

#include "newton_iteration.hpp"
#include "sundials_support.hpp"

namespace sundrape {

/// What the integrators built on SUNDIALS have in common: the state vector, events, counters that outlive restarts.
class SundialsIntegrator : public Integrator {
 public:
  void state(VectorRef q, VectorRef v) const final;
  void interpolate(double time, VectorRef q, VectorRef v) const final;
  [[nodiscard]] std::vector<int> fired() const final;
  [[nodiscard]] IntegratorStatistics statistics() const final;

 protected:
  SundialsIntegrator(const System& system, const IntegratorOptions& options, EventSource* events);

  /// @throws std::invalid_argument  unknowns without mass, which only a differential-algebraic solver takes
  void require_mass(const char* method) const;
  /// y = (q, v)
  void load(double time, ConstVectorRef q, ConstVectorRef v);
  /// Before a restart, which sets the library's counters back.
  void bank();
  [[nodiscard]] int event_count() const { return events_ ? events_->count() : 0; }
  /// Directions for the root finder: events happen where their values fall.
  [[nodiscard]] std::vector<int> falling() const {
    return std::vector<int>(static_cast<std::size_t>(event_count()), -1);
  }
  /// The root function's work; returns SUNDIALS' flag.
  int evaluate_events(double time, N_Vector y, double* values);
  /// Restarts begin with a tenth of the last step; 0 lets the library choose.
  [[nodiscard]] double first_step() const {
    return last_step_ > 0 ? 0.1 * last_step_ : options_.first_step.value_or(0.0);
  }

  /// Interpolant of the last step at a time, into y.
  virtual void interpolant(double time, N_Vector y) const = 0;
  virtual void root_info(int* fired) const = 0;
  /// Counters since the last restart.
  [[nodiscard]] virtual IntegratorStatistics current() const = 0;

  sundials::Context context_;
  sundials::ExceptionCarrier carrier_;
  sundials::MessageKeeper messages_;
  FirstOrderForm form_;
  StepGuard guard_;
  IntegratorOptions options_;
  EventSource* events_;
  sundials::StateVector y_;
  double time_ = 0, last_step_ = 0;
  IntegratorStatistics banked_;
};

/// Implicit steps that must be shorter still lead nowhere [s]: time would no longer pass.
inline constexpr double least_step = 1e-13;

/// What the implicit ones add: Newton's matrix, refreshed at every iteration, and the error weights.
///
/// A matrix from the step's prediction knows nothing of the nodes that meet an obstacle within the step, and the
/// iteration then throws them back and forth: measured on the tablecloth (21² nodes), one matrix a step gives 94
/// refused steps out of 999, one an iteration 10 out of 700.
class ImplicitIntegrator : public SundialsIntegrator {
 protected:
  ImplicitIntegrator(const System& system, std::unique_ptr<LinearSolver> solver, const IntegratorOptions& options,
                     EventSource* events);

  int evaluate_weights(N_Vector y, N_Vector weights);
  /// What is to become of a step whose iteration is about to end with the prediction and this total correction of it,
  /// of which the last iteration's is a part.
  sundials::Verdict judge(double time, N_Vector predicted, N_Vector total, N_Vector last);
  /// What a step that fails, however small, fails for: `otherwise`, unless it was to pass cloth through cloth.
  [[nodiscard]] std::string cause(const std::string& otherwise) const {
    return guard_.refusal() ? describe(*guard_.refusal()) + ", however small the step" : otherwise;
  }
  /// Newton's correction x of the iterate y; r_q and r_v as in CondensedNewton, `force` over the unknowns at y [N];
  /// SUNDIALS' flag.
  int correct(double time, double c, N_Vector y, ConstVectorRef force, ConstVectorRef r_q, ConstVectorRef r_v,
              N_Vector x);
  /// counters of the linear algebra
  [[nodiscard]] IntegratorStatistics with_linear(IntegratorStatistics s) const;

  CondensedNewton newton_;
  ErrorWeights weights_;

 private:
  double last_correction_ = 0;  // |dq| of the iteration before
  Vector before_, end_;         // rows, of the last iterates of a step
};

}  // namespace sundrape

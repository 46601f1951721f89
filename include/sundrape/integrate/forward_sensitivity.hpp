#pragma once
#include <memory>
#include <vector>

#include "sundrape/integrate/bdf_history.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/system/parameter_derivative.hpp"

namespace sundrape {

/// How a motion depends on parameters: the derivative of the integrator's own discrete solution, step by step.
///
/// After each accepted step of CVODE or IDA the step's equations are differentiated at its end (BdfHistory). With
/// s = |p| dq/dp, s' its rate and g their pasts,
///     c s − s' = g_q,    c M s' + K s + C s' = |p| (∂f/∂p − dM/dp a) + M g_v,
/// the condensed Newton system with a right side of its own: one matrix for all parameters, one solve for each, to a
/// tight tolerance and with the whole tangent, unsymmetric parts included. Steps count as given, so that the result is
/// the derivative of what the integrator computes, and converges with its rtol.
class ForwardSensitivity {
 public:
  /// @param solver  of the condensed system; it should want the unsymmetric matrix where that is not symmetric
  ForwardSensitivity(const System& system, std::unique_ptr<LinearSolver> solver,
                     std::vector<ParameterDerivative*> parameters, BdfForm form, int max_order);

  /// Where they are, of all points: |p| dq/dp and |p| dv/dp, 3P, one each a parameter.
  void set(const std::vector<Vector>& q, const std::vector<Vector>& v);
  /// Has the integrator started anew at a state.
  void restart(double time);
  /// Follows the integrator's last step to its end.
  /// @throws IntegrationFailure  the system of the derivatives cannot be solved
  void step(const StepReport& report, const State& all);
  /// |p| dq/dp and |p| dv/dp of all points at a time within the last step, 3P.
  void at(double time, std::size_t parameter, VectorRef s, VectorRef s_dot) const;
  [[nodiscard]] std::size_t parameters() const { return parameters_.size(); }

  [[nodiscard]] const CondensedNewton::Counters& counters() const { return condensed_.counters(); }
  [[nodiscard]] long linear_iterations() const { return linear_iterations_; }

 private:
  void add_damping_product(const State& all, ConstVectorRef rates, VectorRef right_side);
  /// Puts what supports do where they hold.
  void follow_supports(double time, std::size_t parameter, Vector& y) const;

  const System& system_;
  CondensedNewton condensed_;
  TermForces forces_;  // where the step ended
  std::vector<ParameterDerivative*> parameters_;
  BdfHistory history_;
  std::vector<BdfHistory::Past> past_;                                 // one a parameter, 6n
  Vector rows_q_, rows_v_, acceleration_, product_rows_, free_rates_;  // 3n
  Eigen::MatrixXd right_sides_, s_;                                    // 3n, one column a parameter
  Vector shifted_, product_;                                           // 3P
  mutable Vector supports_q_, supports_v_;                             // 3P
  long linear_iterations_ = 0;
};

}  // namespace sundrape

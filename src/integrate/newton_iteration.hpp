#pragma once
#include <functional>

#include <sundials/sundials_nonlinearsolver.h>

#include "sundials_support.hpp"

namespace sundrape::sundials {

/// What is to become of a step whose corrections have become small: taken, iterated further, or tried again smaller.
enum class Verdict { accept, go_on, refuse };

/// Newton's iteration of a step, ended by CVODE's rule and one more: δ_m is the weighted norm of correction m, and the
/// iterate is taken once δ_m min(1, rate) ≤ tolerance, rate being max(0.3 rate, δ_m/δ_{m−1}), and 1 at the start of
/// each step, and once no coordinate alone is expected to be off by more than twice its tolerance.
///
/// Where the matrix is not the tangent the iteration converges linearly, and its first correction says nothing of how
/// far it has to go: there δ_m r/(1 − r) ≤ tolerance with r = δ_m/δ_{m−1} is asked for, of all but negligible
/// corrections.
///
/// The norm is a mean over all unknowns: of a large net it lets a single node sink into an obstacle by many times the
/// tolerance. IDA's own rule carries the rate over from step to step where the linear solver needs no setup, and so
/// takes the first iterate even when a node has just met an obstacle.
class NewtonIteration {
 public:
  /// @param like  a vector of the state's size
  NewtonIteration(const StateVector& like, const Context& context);
  NewtonIteration(const NewtonIteration&) = delete;  // SUNDIALS keeps its address
  NewtonIteration& operator=(const NewtonIteration&) = delete;
  NewtonIteration(NewtonIteration&&) = delete;
  NewtonIteration& operator=(NewtonIteration&&) = delete;
  ~NewtonIteration() = default;

  [[nodiscard]] SUNNonlinearSolver get() const { return solver_.get(); }
  /// Once the integrator has the solver, which sets its own rule.
  /// @param doubtful  the matrix is not the tangent (friction): small corrections alone do not mean convergence
  /// @param judge     asked once corrections are small: of the correction of the prediction so far, and of the last
  ///                  iteration's part of it
  void use_rule(bool doubtful, std::function<Verdict(N_Vector, N_Vector)> judge);

 private:
  struct Free {
    void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFree(s); }
  };
  static int test(SUNNonlinearSolver solver, N_Vector total, N_Vector correction, realtype tolerance, N_Vector weights,
                  void* data);

  std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, Free> solver_;
  bool doubtful_ = false;
  std::function<Verdict(N_Vector, N_Vector)> judge_;
  double rate_ = 1, previous_ = 0;
};

}  // namespace sundrape::sundials

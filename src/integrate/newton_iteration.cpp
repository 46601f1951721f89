#include "newton_iteration.hpp"

#include <algorithm>

#include <sunnonlinsol/sunnonlinsol_newton.h>

namespace sundrape::sundials {
namespace {

constexpr double least_rate_change = 0.3;
constexpr double negligible = 1e-3;  // part of the tolerance that no slow convergence can hide behind
constexpr double divergence = 2;     // growth of the correction
constexpr double largest = 2;        // weighted error of one coordinate

/// Largest weighted change of a coordinate; y = (q, v).
double largest_move(N_Vector correction, N_Vector weights) {
  const auto n = N_VGetLength(correction) / 2;
  return values(correction).head(n).cwiseProduct(values(weights).head(n)).lpNorm<Eigen::Infinity>();
}

}  // namespace

NewtonIteration::NewtonIteration(const StateVector& like, const Context& context)
    : solver_(SUNNonlinSol_Newton(like.get(), context)) {
  if (!solver_) throw std::bad_alloc();
}

void NewtonIteration::use_rule(bool doubtful, std::function<Verdict(N_Vector, N_Vector)> judge) {
  doubtful_ = doubtful;
  judge_ = std::move(judge);
  require_success(SUNNonlinSolSetConvTestFn(solver_.get(), test, this), "SUNNonlinSolSetConvTestFn");
}

int NewtonIteration::test(SUNNonlinearSolver solver, N_Vector total, N_Vector correction, realtype tolerance,
                          N_Vector weights, void* data) {
  auto& me = *static_cast<NewtonIteration*>(data);
  int iteration = 0;
  SUNNonlinSolGetCurIter(solver, &iteration);
  const double size = N_VWrmsNorm(correction, weights);
  me.rate_ = iteration > 0 ? std::max(least_rate_change * me.rate_, size / me.previous_) : 1.0;
  const double expected = std::min(1.0, me.rate_);
  bool near = true;
  if (me.doubtful_ && size > negligible * tolerance) {
    // a linear iteration ends size · rate/(1 − rate) away, which its first correction cannot tell
    const double rate = iteration > 0 ? size / me.previous_ : 1.0;
    near = rate < 1 && size * rate / (1 - rate) <= tolerance;
  }
  if (near && size * expected <= tolerance && largest_move(correction, weights) * expected <= largest) {
    const auto verdict = me.judge_(total, correction);
    if (verdict != Verdict::go_on) return verdict == Verdict::accept ? SUN_NLS_SUCCESS : SUN_NLS_CONV_RECVR;
  }
  if (iteration > 0 && size > divergence * me.previous_) return SUN_NLS_CONV_RECVR;
  me.previous_ = size;
  return SUN_NLS_CONTINUE;
}

}  // namespace sundrape::sundials

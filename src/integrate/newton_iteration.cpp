#include "newton_iteration.hpp"

#include <algorithm>

#include <sunnonlinsol/sunnonlinsol_newton.h>

namespace sundrape::sundials {
namespace {

constexpr double least_rate_change = 0.3;
constexpr double divergence = 2;  // growth of the correction

}  // namespace

NewtonIteration::NewtonIteration(const StateVector& like, const Context& context)
    : solver_(SUNNonlinSol_Newton(like.get(), context)) {
  if (!solver_) throw std::bad_alloc();
}

void NewtonIteration::use_rule() {
  require_success(SUNNonlinSolSetConvTestFn(solver_.get(), test, this), "SUNNonlinSolSetConvTestFn");
}

int NewtonIteration::test(SUNNonlinearSolver solver, N_Vector /*iterate*/, N_Vector correction, realtype tolerance,
                          N_Vector weights, void* data) {
  auto& me = *static_cast<NewtonIteration*>(data);
  int iteration = 0;
  SUNNonlinSolGetCurIter(solver, &iteration);
  const double size = N_VWrmsNorm(correction, weights);
  me.rate_ = iteration > 0 ? std::max(least_rate_change * me.rate_, size / me.previous_) : 1.0;
  if (size * std::min(1.0, me.rate_) <= tolerance) return SUN_NLS_SUCCESS;
  if (iteration > 0 && size > divergence * me.previous_) return SUN_NLS_CONV_RECVR;
  me.previous_ = size;
  return SUN_NLS_CONTINUE;
}

}  // namespace sundrape::sundials

#include "sundials_support.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace sundrape::sundials {

Context::Context() {
  SUNContext context = nullptr;
  require_success(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  context_.reset(context);
}

StateVector::StateVector(Eigen::Index size, const Context& context) : vector_(N_VNew_Serial(size, context)) {
  if (!vector_) throw std::bad_alloc();
  // the library's own loops are scalar, and take a sixth of a whole run
  auto* const ops = vector_->ops;
  ops->nvlinearsum = [](realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
    sundials::values(z).array() = a * sundials::values(x).array() + b * sundials::values(y).array();
  };
  ops->nvscale = [](realtype a, N_Vector x, N_Vector z) {
    sundials::values(z).array() = a * sundials::values(x).array();
  };
  ops->nvconst = [](realtype a, N_Vector z) { sundials::values(z).setConstant(a); };
  ops->nvwrmsnorm = [](N_Vector x, N_Vector w) {
    return sundials::values(x).cwiseProduct(sundials::values(w)).norm() /
           std::sqrt(static_cast<double>(N_VGetLength(x)));
  };
}

Eigen::Map<Vector> StateVector::values() const { return sundials::values(vector_.get()); }

Eigen::Map<Vector> values(N_Vector v) { return {N_VGetArrayPointer(v), N_VGetLength(v)}; }

EmbeddedSolver::EmbeddedSolver(std::function<int(N_Vector, N_Vector)> solve, const Context& context)
    : solve_(std::make_unique<std::function<int(N_Vector, N_Vector)>>(std::move(solve))),
      solver_(SUNLinSolNewEmpty(context)) {
  if (!solver_) throw std::bad_alloc();
  solver_->content = solve_.get();
  solver_->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_EMBEDDED; };
  solver_->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  solver_->ops->solve = [](SUNLinearSolver s, SUNMatrix, N_Vector x, N_Vector b, realtype) {
    return (*static_cast<std::function<int(N_Vector, N_Vector)>*>(s->content))(x, b);
  };
}

void require_success(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(fmt::format("{} failed with code {}", call, flag));
}

void MessageKeeper::handle(int code, const char* /*module*/, const char* /*function*/, char* message, void* keeper) {
  if (code < 0) static_cast<MessageKeeper*>(keeper)->last = message;
}

}  // namespace sundrape::sundials

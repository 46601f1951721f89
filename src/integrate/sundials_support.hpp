#pragma once
// The one place that owns SUNDIALS objects; a change of its major version is work here and in the integrators
// only.
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>

#include "sundrape/types.hpp"

namespace sundrape::sundials {

class Context {
 public:
  Context();
  operator SUNContext() const { return context_.get(); }  // NOLINT(google-explicit-constructor): a handle

 private:
  struct Free {
    void operator()(SUNContext context) const { SUNContext_Free(&context); }
  };
  std::unique_ptr<std::remove_pointer_t<SUNContext>, Free> context_;
};

/// A serial N_Vector that owns its data, seen as an Eigen vector.
class StateVector {
 public:
  StateVector(Eigen::Index size, const Context& context);
  [[nodiscard]] N_Vector get() const { return vector_.get(); }
  [[nodiscard]] Eigen::Map<Vector> values() const;

 private:
  struct Free {
    void operator()(N_Vector v) const { N_VDestroy(v); }
  };
  std::unique_ptr<std::remove_pointer_t<N_Vector>, Free> vector_;
};

[[nodiscard]] Eigen::Map<Vector> values(N_Vector v);

/// A matrix-embedded SUNLinearSolver whose solve(x, b) is ours; 0 is success, > 0 a failure that a smaller step may
/// cure.
class EmbeddedSolver {
 public:
  EmbeddedSolver(std::function<int(N_Vector x, N_Vector b)> solve, const Context& context);
  [[nodiscard]] SUNLinearSolver get() const { return solver_.get(); }

 private:
  struct Free {
    void operator()(SUNLinearSolver s) const { SUNLinSolFreeEmpty(s); }
  };
  std::unique_ptr<std::function<int(N_Vector, N_Vector)>> solve_;
  std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Free> solver_;
};

/// Keeps C++ exceptions from crossing SUNDIALS' C frames: run() returns −1 and remembers, rethrow() throws on the far
/// side.
class ExceptionCarrier {
 public:
  template <class Body>
  int run(const Body& body) noexcept {
    try {
      return body();
    } catch (...) {
      caught_ = std::current_exception();
      return -1;
    }
  }
  void rethrow() {
    if (auto caught = std::exchange(caught_, nullptr)) std::rethrow_exception(caught);
  }

 private:
  std::exception_ptr caught_;
};

/// @throws std::runtime_error  naming the call, unless the flag says success
void require_success(int flag, const char* call);
/// The last message that SUNDIALS' error handler was given is kept here instead of going to stderr.
struct MessageKeeper {
  std::string last;
  static void handle(int code, const char* module, const char* function, char* message, void* keeper);
};

}  // namespace sundrape::sundials

// What condensing saves over a run: the first 0.2 s of the tablecloth by CVODE with a Newton matrix of full size (6n)
// and SUNDIALS' own KLU, by the library's CVODE with its solvers, and by the Runge–Kutta method. Arguments: nodes per
// side (default 21 41).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <omp.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include "sundrape/integrate/error_weights.hpp"
#include "sundrape/integrate/first_order_form.hpp"
#include "sundrape/integrate/stability_limit.hpp"

#include "integrate/sundials_support.hpp"
#include "support/cpu_clock.hpp"
#include "support/full_size_matrix.hpp"
#include "support/tablecloth.hpp"
#include "support/timed_solver.hpp"

namespace sundrape {
namespace {

using sundials::require_success;

constexpr double duration = 0.2;  // [s]
constexpr double enough = 10;     // [s] of processor time for a method; then it is not repeated
constexpr int calls = 3;          // at most, of which the fastest counts

struct Run {
  double cpu = 0;                // [s]
  double factor = 0, solve = 0;  // of that in linear algebra [s]
  long steps = 0, newton_iterations = 0, factorizations = 0, evaluations = 0;
  Vector q;  // rows, where it ended

  [[nodiscard]] double linear() const { return factor + solve; }
};

/// SUNDIALS' KLU with a clock around its two operations.
class TimedKlu {
 public:
  TimedKlu(N_Vector y, SUNMatrix matrix, const sundials::Context& context)
      : timed_(std::make_unique<Timed>()), solver_(SUNLinSolNewEmpty(context)) {
    timed_->klu.reset(SUNLinSol_KLU(y, matrix, context));
    if (!timed_->klu || !solver_) throw std::bad_alloc();
    require_success(SUNLinSol_KLUSetOrdering(timed_->klu.get(), 0),
                    "SUNLinSol_KLUSetOrdering");  // AMD, as the library's
    solver_->content = timed_.get();
    solver_->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
    solver_->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
    solver_->ops->initialize = [](SUNLinearSolver s) { return SUNLinSolInitialize(timed(s).klu.get()); };
    solver_->ops->setup = [](SUNLinearSolver s, SUNMatrix a) {
      const CpuClock clock;
      const int flag = SUNLinSolSetup(timed(s).klu.get(), a);
      timed(s).seconds.factor += clock.seconds();
      return flag;
    };
    solver_->ops->solve = [](SUNLinearSolver s, SUNMatrix a, N_Vector x, N_Vector b, realtype tolerance) {
      const CpuClock clock;
      const int flag = SUNLinSolSolve(timed(s).klu.get(), a, x, b, tolerance);
      timed(s).seconds.solve += clock.seconds();
      return flag;
    };
  }

  [[nodiscard]] SUNLinearSolver get() const { return solver_.get(); }
  [[nodiscard]] const TimedSolver::Seconds& seconds() const { return timed_->seconds; }

 private:
  using Solver = std::remove_pointer_t<SUNLinearSolver>;
  struct Free {
    void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
  };
  struct FreeEmpty {
    void operator()(SUNLinearSolver s) const { SUNLinSolFreeEmpty(s); }
  };
  struct Timed {
    std::unique_ptr<Solver, Free> klu;
    TimedSolver::Seconds seconds;
  };
  static Timed& timed(SUNLinearSolver s) { return *static_cast<Timed*>(s->content); }

  std::unique_ptr<Timed> timed_;
  std::unique_ptr<Solver, FreeEmpty> solver_;
};

/// CVODE as a user of SUNDIALS has it: first-order form, sparse Jacobian, KLU. Tolerances, order and the refreshing of
/// the matrix are those of the library's CVODE.
class FullSizeCvode {
 public:
  explicit FullSizeCvode(const Tablecloth& cloth)
      : form_(cloth.system()),
        weights_{cloth.options.rtol, cloth.options.atol_position, cloth.options.atol_velocity, cloth.q},
        jacobian_(cloth.system()),
        y_(form_.size(), context_),
        matrix_(SUNSparseMatrix(form_.size(), form_.size(), jacobian_.entries(), CSC_MAT, context_)),
        solver_(y_.get(), matrix_.get(), context_),
        memory_(CVodeCreate(CV_BDF, context_)),
        q_(cloth.model.initial.size()),
        v_(q_.size()) {
    if (!matrix_ || !memory_) throw std::bad_alloc();
    y_.values() << cloth.q, cloth.v;
    auto* m = memory_.get();
    const auto right_side = [](realtype t, N_Vector y, N_Vector y_dot, void* data) {
      return self(data).form_.rates(t, sundials::values(y), sundials::values(y_dot)) ? 0 : 1;
    };
    const auto weigh = [](N_Vector y, N_Vector w, void* data) {
      self(data).weights_.evaluate(sundials::values(y), sundials::values(w));
      return 0;
    };
    const auto jacobian = [](realtype t, N_Vector y, N_Vector, SUNMatrix j, void* data, N_Vector, N_Vector, N_Vector) {
      self(data).write_jacobian(t, sundials::values(y), j);
      return 0;
    };
    require_success(CVodeInit(m, right_side, 0, y_.get()), "CVodeInit");
    require_success(CVodeSetUserData(m, this), "CVodeSetUserData");
    require_success(CVodeWFtolerances(m, weigh), "CVodeWFtolerances");
    require_success(CVodeSetMaxOrd(m, cloth.options.max_order), "CVodeSetMaxOrd");
    require_success(CVodeSetLinearSolver(m, solver_.get(), matrix_.get()), "CVodeSetLinearSolver");
    require_success(CVodeSetJacFn(m, jacobian), "CVodeSetJacFn");
    require_success(CVodeSetLSetupFrequency(m, 1), "CVodeSetLSetupFrequency");
    require_success(CVodeSetJacEvalFrequency(m, 1), "CVodeSetJacEvalFrequency");
    require_success(CVodeSetMaxConvFails(m, 20), "CVodeSetMaxConvFails");
    require_success(CVodeSetMaxErrTestFails(m, 20), "CVodeSetMaxErrTestFails");
  }
  FullSizeCvode(const FullSizeCvode&) = delete;
  FullSizeCvode& operator=(const FullSizeCvode&) = delete;

  [[nodiscard]] Run run() {
    Run run;
    const CpuClock clock;
    auto* m = memory_.get();
    require_success(CVodeSetStopTime(m, duration), "CVodeSetStopTime");
    for (double t = 0; t < duration;) require_success(CVode(m, duration, y_.get(), &t, CV_ONE_STEP), "CVode");
    run.cpu = clock.seconds();
    run.factor = solver_.seconds().factor;
    run.solve = solver_.seconds().solve;
    CVodeGetNumSteps(m, &run.steps);
    CVodeGetNumNonlinSolvIters(m, &run.newton_iterations);
    CVodeGetNumLinSolvSetups(m, &run.factorizations);
    run.evaluations = form_.evaluations();
    run.q = y_.values().head(form_.size() / 2);
    return run;
  }

 private:
  struct Free {
    void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
    void operator()(void* memory) const { CVodeFree(&memory); }
  };

  static FullSizeCvode& self(void* data) { return *static_cast<FullSizeCvode*>(data); }

  void write_jacobian(double t, ConstVectorRef y, SUNMatrix to) {
    const auto n = y.size() / 2;
    form_.system().expand(t, y.head(n), y.tail(n), q_, v_);
    jacobian_.assemble({t, q_, v_});
    jacobian_.fill_jacobian();
    std::ranges::copy(jacobian_.column_start(), SUNSparseMatrix_IndexPointers(to));
    std::ranges::copy(jacobian_.row(), SUNSparseMatrix_IndexValues(to));
    std::ranges::copy(jacobian_.value(), SUNSparseMatrix_Data(to));
  }

  sundials::Context context_;
  FirstOrderForm form_;
  ErrorWeights weights_;
  FullSizeMatrix jacobian_;
  sundials::StateVector y_;
  std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Free> matrix_;
  TimedKlu solver_;
  std::unique_ptr<void, Free> memory_;
  Vector q_, v_;  // all points
};

/// Steps an integrator to the end.
Run advance(const Tablecloth& cloth, Integrator& integrator) {
  Run run;
  const CpuClock clock;
  integrator.start(0, cloth.q, cloth.v);
  for (double t = 0; t < duration;) t = integrator.step(duration).time;
  run.cpu = clock.seconds();
  const auto s = integrator.statistics();
  run.steps = s.steps;
  run.newton_iterations = s.newton_iterations;
  run.factorizations = s.linear.factorizations;
  run.evaluations = s.force_evaluations;
  run.q = cloth.q;
  Vector v(run.q.size());
  integrator.state(run.q, v);
  return run;
}

Run condensed(const Tablecloth& cloth, SolverKind kind) {
  TimedSolver::Seconds seconds;
  const auto integrator =
      make_cvode(cloth.system(), std::make_unique<TimedSolver>(make_linear_solver(kind), seconds), cloth.options);
  auto run = advance(cloth, *integrator);
  run.factor = seconds.factor;
  run.solve = seconds.solve;
  return run;
}

Run runge_kutta(const Tablecloth& cloth) {
  const Vector still = Vector::Zero(cloth.model.initial.size());
  auto options = cloth.options;
  options.fixed_step = 0.8 * rk4_stability_limit(cloth.system(), {0, cloth.model.initial, still}).step;
  const auto integrator = make_rk4(cloth.system(), options);
  return advance(cloth, *integrator);
}

/// The fastest of some runs.
Run fastest(const std::function<Run()>& once) {
  Run best = once();
  double spent = best.cpu;
  for (int k = 1; k < calls && spent < enough; ++k) {
    Run next = once();
    spent += next.cpu;
    if (next.cpu < best.cpu) best = std::move(next);
  }
  return best;
}

void compare(int nodes) {
  fmt::print("\n{0}x{0} nodes, {1} s\n", nodes, duration);
  fmt::print("{:28} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>7} {:>8} {:>9}\n", "", "CPU s", "factor s",
             "solve s", "lin. alg", "steps", "Newton", "matrices", "forces", "CPU /", "lin. /", "RMS mm");
  const auto cloth = tablecloth(nodes);
  const auto free = tablecloth(nodes, {undamped()});
  const auto print = [&](const std::string& name, const Run& r, const Run& against) {
    const double away = (r.q - against.q).norm() / std::sqrt(static_cast<double>(r.q.size() / 3));
    fmt::print("{:28} {:8.3f} {:8.3f} {:8.3f} {:7.0f}% {:8} {:8} {:8} {:9} {:7.2f} {:8.2f} {:9.3f}\n", name, r.cpu,
               r.factor, r.solve, 100 * r.linear() / r.cpu, r.steps, r.newton_iterations, r.factorizations,
               r.evaluations, r.cpu / against.cpu, r.linear() / against.linear(), 1e3 * away);
    std::fflush(stdout);
  };
  // A coarse net's contact is stiffer than its threads, and the estimate of the limit does not see contact.
  const auto print_runge_kutta = [&](const std::string& name, const Tablecloth& which, const Run& against) {
    try {
      print(name, fastest([&] { return runge_kutta(which); }), against);
    } catch (const IntegrationFailure& failure) {
      fmt::print("{:28} {}\n", name, failure.what());
    }
  };
  using enum SolverKind;
  const Run reference = fastest([&] { return condensed(cloth, conjugate_gradients); });
  print("condensed, conj. gradients", reference, reference);
  print("condensed, Cholesky", fastest([&] { return condensed(cloth, cholesky); }), reference);
  print("condensed, KLU", fastest([&] { return condensed(cloth, lu); }), reference);
  print("full size, SUNDIALS' KLU", fastest([&] { return FullSizeCvode(cloth).run(); }), reference);
  print_runge_kutta("RK4", cloth, reference);
  const Run reference_free = fastest([&] { return condensed(free, conjugate_gradients); });
  print("undamped, conj. gradients", reference_free, reference_free);
  print_runge_kutta("undamped, RK4", free, reference_free);
}

}  // namespace
}  // namespace sundrape

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  std::vector<int> sizes;
  for (int k = 1; k < argc; ++k)
    if (const int nodes = std::atoi(argv[k]); nodes > 2) sizes.push_back(nodes);
  if (sizes.empty()) sizes = {21, 41};
  for (const int nodes : sizes) sundrape::compare(nodes);
}

// What condensing saves on one Newton matrix and two solves with it: the tablecloth in the middle of its fall, by KLU
// at full size (6n) and by each of the library's solvers at half size (3n). Arguments: nodes per side (default 41).
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <klu.h>
#include <omp.h>

#include "support/cpu_clock.hpp"
#include "support/full_size_matrix.hpp"
#include "support/tablecloth.hpp"

namespace {

using namespace sundrape;

constexpr double middle_of_fall = 0.1;  // [s]
constexpr int solves = 2;
constexpr int calls = 7;  // of which the fastest counts

/// KLU with the ordering that the library's Lu has.
class FullSizeKlu {
 public:
  explicit FullSizeKlu(FullSizeMatrix& matrix) : matrix_(matrix) {
    klu_l_defaults(&common_);
    common_.ordering = 0;  // AMD
    symbolic_ = klu_l_analyze(matrix.columns(), start(), row(), &common_);
    factor();
  }
  FullSizeKlu(const FullSizeKlu&) = delete;
  FullSizeKlu& operator=(const FullSizeKlu&) = delete;
  ~FullSizeKlu() {
    klu_l_free_numeric(&numeric_, &common_);
    klu_l_free_symbolic(&symbolic_, &common_);
  }

  /// With new pivots.
  void factor() {
    klu_l_free_numeric(&numeric_, &common_);
    numeric_ = klu_l_factor(start(), row(), matrix_.value().data(), symbolic_, &common_);
    if (!numeric_) throw std::runtime_error("KLU cannot factor the matrix of full size");
  }
  /// With the pivots of the last factorisation.
  void refactor() { klu_l_refactor(start(), row(), matrix_.value().data(), symbolic_, numeric_, &common_); }
  void solve(Vector& x) { klu_l_solve(symbolic_, numeric_, x.size(), 1, x.data(), &common_); }
  [[nodiscard]] double entries() const { return static_cast<double>(numeric_->lnz + numeric_->unz); }

 private:
  SuiteSparse_long* start() { return reinterpret_cast<SuiteSparse_long*>(matrix_.column_start().data()); }
  SuiteSparse_long* row() { return reinterpret_cast<SuiteSparse_long*>(matrix_.row().data()); }

  FullSizeMatrix& matrix_;
  klu_l_common common_{};
  klu_l_symbolic* symbolic_ = nullptr;
  klu_l_numeric* numeric_ = nullptr;
};

/// A Newton system that a run met: its matrix belongs to (q, v) and c, its right side to the forces there.
struct NewtonSystem {
  double time, c;
  Vector q, v;      // rows
  Vector r_q, r_v;  // rows
};

NewtonSystem newton_system(const Tablecloth& cloth) {
  const auto integrator =
      make_cvode(cloth.system(), make_linear_solver(SolverKind::conjugate_gradients), cloth.options);
  integrator->start(0, cloth.q, cloth.v);
  StepReport report;
  while (report.time < middle_of_fall) report = integrator->step(2 * middle_of_fall);
  NewtonSystem newton{
      .time = report.time, .c = 1.5 / report.step_size, .q = cloth.q, .v = cloth.v, .r_q = {}, .r_v = {}};
  integrator->state(newton.q, newton.v);
  // What a first iteration has to correct: the rates that a step of this length leaves out of balance.
  Vector q(cloth.model.initial.size());
  Vector v(q.size());
  Vector f(q.size());
  cloth.system().expand(0, newton.q, newton.v, q, v);
  cloth.system().force({report.time, q, v}, f);
  newton.r_v.resize(newton.q.size());
  cloth.system().unknowns().gather(f, newton.r_v);
  cloth.system().unknowns().clear_held(newton.r_v);
  newton.r_q = 1e-2 * newton.v;
  return newton;
}

struct Result {
  std::string name;
  double factor, solve;  // [s]
  double correction;     // |Δq| [m], to compare the methods
  double iterations = 0;

  [[nodiscard]] double total() const { return factor + solves * solve; }
};

std::vector<Result> at_full_size(const Tablecloth& cloth, const NewtonSystem& newton) {
  Vector q(cloth.model.initial.size());
  Vector v(q.size());
  cloth.system().expand(0, newton.q, newton.v, q, v);
  FullSizeMatrix matrix(cloth.system());
  const double assembly = least_cpu(calls, [&] { matrix.assemble({newton.time, q, v}); });
  const double fill = least_cpu(calls, [&] { matrix.fill_newton(newton.c); });
  FullSizeKlu klu(matrix);
  fmt::print(
      "full size: {} columns, {} entries, {:.3g} in the factors; assembling K and C {:.2f} ms, writing out {:.2f} ms\n",
      matrix.columns(), matrix.entries(), klu.entries(), 1e3 * assembly, 1e3 * fill);
  const double factor = least_cpu(calls, [&] { klu.factor(); });
  const double refactor = least_cpu(calls, [&] { klu.refactor(); });
  Vector right_side(matrix.columns());
  right_side << newton.r_q, newton.r_v;
  Vector x;
  const double solve = least_cpu(calls, [&] {
    x = right_side;
    klu.solve(x);
  });
  const double correction = x.head(newton.q.size()).norm();
  return {{"full size, KLU, new pivots", factor, solve, correction},
          {"full size, KLU, old pivots", refactor, solve, correction}};
}

/// Factoring and solving alone; the solves with the right side's products and the eliminated rates.
Result condensed(const Tablecloth& cloth, const NewtonSystem& newton, SolverKind kind) {
  auto owned = make_linear_solver(kind);
  auto& solver = *owned;
  CondensedNewton condensed(cloth.system(), std::move(owned), cloth.options.linear_tolerance);
  const auto require = [](bool good) {
    if (!good) throw std::runtime_error("the condensed matrix was not solved");
  };
  require(condensed.prepare(newton.time, newton.c, newton.q, newton.v) == FactorStatus::ok);
  const double factor = least_cpu(calls, [&] { require(solver.factor(condensed.matrix()) == FactorStatus::ok); });
  Vector dq(newton.q.size());
  Vector dv(newton.q.size());
  int iterations = 0;
  const double solve = least_cpu(calls, [&] {
    const auto report = condensed.solve(newton.r_q, newton.r_v, dq, dv);
    require(report.ok);
    iterations = report.iterations;
  });
  return {fmt::format("condensed, {}", solver.name()), factor, solve, dq.norm(), static_cast<double>(iterations)};
}

void compare(int nodes) {
  const auto cloth = tablecloth(nodes);
  const auto newton = newton_system(cloth);
  fmt::print("\n{0}x{0} nodes at t = {1:.3f} s, c = {2:.0f} 1/s\n", nodes, newton.time, newton.c);
  auto results = at_full_size(cloth, newton);
  for (const auto kind : {SolverKind::lu, SolverKind::cholesky, SolverKind::conjugate_gradients})
    results.push_back(condensed(cloth, newton, kind));
  fmt::print("{:34} {:>10} {:>10} {:>14} {:>10} {:>10} {:>10} {:>12}\n", "CPU [ms]", "factor", "solve",
             fmt::format("factor+{}solves", solves), "/ new", "/ old", "iterations", "|dq| [m]");
  for (const auto& r : results)
    fmt::print("{:34} {:10.2f} {:10.2f} {:14.2f} {:10.1f} {:10.1f} {:10} {:12.6g}\n", r.name, 1e3 * r.factor,
               1e3 * r.solve, 1e3 * r.total(), results[0].total() / r.total(), results[1].total() / r.total(),
               r.iterations, r.correction);
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  std::vector<int> sizes;
  for (int k = 1; k < argc; ++k)
    if (const int nodes = std::atoi(argv[k]); nodes > 2) sizes.push_back(nodes);
  if (sizes.empty()) sizes = {41};
  for (const int nodes : sizes) compare(nodes);
}

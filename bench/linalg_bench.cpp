// Linear algebra of the condensed system on a tablecloth net of 21², 41², 81² nodes; the argument is nodes per side.
#include <benchmark/benchmark.h>

#include "sundrape/linalg/block_incomplete_cholesky.hpp"
#include "sundrape/linalg/cholesky.hpp"
#include "sundrape/linalg/conjugate_gradients.hpp"
#include "sundrape/linalg/ldlt.hpp"
#include "sundrape/linalg/lu.hpp"

#include "support/model_matrices.hpp"

namespace {

using namespace sundrape;

ModelMatrix net(const benchmark::State& state, double rate = 600) {
  return net_matrix({.nodes_per_side = static_cast<int>(state.range(0)), .rate = rate});
}

void sizes(benchmark::internal::Benchmark* bench) { bench->Arg(21)->Arg(41)->Arg(81)->Unit(benchmark::kMillisecond); }

void spmv_double(benchmark::State& state) {
  const auto model = net(state);
  const Vector x = random_vector(3 * model.matrix->size(), 1);
  Vector y(x.size());
  for (auto _ : state) {
    model.matrix->multiply(x, y);
    benchmark::DoNotOptimize(y.data());
  }
}
BENCHMARK(spmv_double)->Apply(sizes);

void spmv_float(benchmark::State& state) {
  const auto model = net(state);
  PaddedMatrix padded(*model.structure);
  padded.copy(*model.matrix);
  PaddedVector x(4 * padded.size());
  pad(random_vector(3 * padded.size(), 1), 1, x);
  PaddedVector y(x.size());
  for (auto _ : state) {
    padded.multiply(x, y);
    benchmark::DoNotOptimize(y.data());
  }
}
BENCHMARK(spmv_float)->Apply(sizes);

void float_copy(benchmark::State& state) {
  const auto model = net(state);
  PaddedMatrix padded(*model.structure);
  for (auto _ : state) padded.copy(*model.matrix);
}
BENCHMARK(float_copy)->Apply(sizes);

void incomplete_cholesky_build(benchmark::State& state) {
  const auto model = net(state);
  PaddedMatrix padded(*model.structure);
  padded.copy(*model.matrix);
  BlockIncompleteCholesky preconditioner;
  preconditioner.analyse(*model.structure);
  for (auto _ : state)
    if (!preconditioner.build(padded)) state.SkipWithError("breakdown");
  state.counters["shift"] = preconditioner.shift();
}
BENCHMARK(incomplete_cholesky_build)->Apply(sizes);

void incomplete_cholesky_apply(benchmark::State& state) {
  const auto model = net(state);
  PaddedMatrix padded(*model.structure);
  padded.copy(*model.matrix);
  BlockIncompleteCholesky preconditioner;
  preconditioner.analyse(*model.structure);
  if (!preconditioner.build(padded)) state.SkipWithError("breakdown");
  PaddedVector r(4 * padded.size());
  pad(random_vector(3 * padded.size(), 1), 1, r);
  PaddedVector z(r.size());
  for (auto _ : state) {
    preconditioner.apply(r, z);
    benchmark::DoNotOptimize(z.data());
  }
}
BENCHMARK(incomplete_cholesky_apply)->Apply(sizes);

/// Arguments: nodes per side, c [1/s], modification in %, −log10 of the tolerance. Factor and one solve.
void conjugate_gradients(benchmark::State& state) {
  const auto model = net(state, static_cast<double>(state.range(1)));
  ConjugateGradients solver(std::make_unique<BlockIncompleteCholesky>(0.01 * static_cast<double>(state.range(2))));
  solver.analyse(*model.structure);
  const Vector b = random_vector(3 * model.matrix->size(), 1);
  Vector x(b.size());
  SolveReport report;
  for (auto _ : state) {
    if (solver.factor(*model.matrix) != FactorStatus::ok) state.SkipWithError("breakdown");
    report = solver.solve(b, x, std::pow(10.0, -static_cast<double>(state.range(3))));
    if (!report.ok) state.SkipWithError(report.problem.c_str());
  }
  state.counters["iterations"] = report.iterations;
}
BENCHMARK(conjugate_gradients)
    ->ArgsProduct({{21, 41, 81}, {600, 60}, {0, 95}, {2, 4, 8}})
    ->Unit(benchmark::kMillisecond);

template <class Solver>
void analyse(benchmark::State& state) {
  const auto model = net(state);
  Solver solver;
  for (auto _ : state) solver.analyse(*model.structure);
}
BENCHMARK(analyse<Cholesky>)->Apply(sizes);
BENCHMARK(analyse<Lu>)->Apply(sizes);

template <class Solver>
void factor(benchmark::State& state) {
  const auto model = net(state);
  Solver solver;
  solver.analyse(*model.structure);
  for (auto _ : state)
    if (solver.factor(*model.matrix) != FactorStatus::ok) state.SkipWithError("not factored");
}
BENCHMARK(factor<Cholesky>)->Apply(sizes);
BENCHMARK(factor<Lu>)->Apply(sizes);

template <class Solver>
void solve(benchmark::State& state) {
  const auto model = net(state);
  Solver solver;
  if (solver.factor(*model.matrix) != FactorStatus::ok) state.SkipWithError("not factored");
  const Vector b = random_vector(3 * model.matrix->size(), 1);
  Vector x(b.size());
  for (auto _ : state)
    if (!solver.solve(b, x, 0).ok) state.SkipWithError("not solved");
}
BENCHMARK(solve<Cholesky>)->Apply(sizes);
BENCHMARK(solve<Lu>)->Apply(sizes);

void inertia(benchmark::State& state) {
  const auto model = net(state);
  Ldlt ldlt;
  ldlt.analyse(*model.structure);
  for (auto _ : state)
    if (ldlt.factor(*model.matrix) == FactorStatus::singular) state.SkipWithError("not factored");
}
BENCHMARK(inertia)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();

// Forces and tangents of the tablecloth's net, bent into waves that touch the table: time for each element of a term.
// The argument is nodes per side. One thread.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include "support/tablecloth.hpp"

namespace {

using namespace sundrape;

/// A net in motion, with the couplings of its terms.
struct Net {
  Tablecloth cloth;
  Vector q, v;  // all points
  Pattern::Built pattern;

  [[nodiscard]] State state() const { return {0, q, v}; }
  [[nodiscard]] std::size_t elements(std::size_t term) const {
    const auto& table = pattern.tables[term];
    const auto points = static_cast<std::size_t>(table.points_per_element);
    return table.slots.size() / (points * (points + 1) / 2);
  }
};

Pattern::Built couplings(const System& system) {
  Pattern pattern(system.unknowns().row_of_point());
  for (const auto& term : system.terms()) term->declare_pattern(pattern);
  return pattern.build();
}

/// Waves 5 cm long and 6 mm high along both threads, out of phase, half of them below the table's top; moving.
std::shared_ptr<const Net> wavy_net(int nodes) {
  auto cloth = tablecloth(nodes);
  Vector q = cloth.model.initial;
  Vector v(q.size());
  const double wave_number = 2 * std::numbers::pi / 0.05;
  for (int i = 0; i < q.size() / 3; ++i) {
    const Vector3 x = point(q, i);
    const double wave = std::sin(wave_number * x.x()) + std::cos(wave_number * (x.y() + 0.3 * x.x()));
    point(q, i) += Vector3(1e-4 * wave, -1e-4 * wave, 1.5e-3 * wave);
    point(v, i) = Vector3(0.01, 0.02, 0.1) * wave;
  }
  auto pattern = couplings(cloth.system());
  return std::make_shared<const Net>(Net{std::move(cloth), std::move(q), std::move(v), std::move(pattern)});
}

void per_element(benchmark::State& bench, std::size_t elements) {
  using benchmark::Counter;
  bench.counters["elements"] = static_cast<double>(elements);
  bench.counters["per_element"] =
      Counter(static_cast<double>(elements), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void force_of_term(benchmark::State& bench, const Net& net, std::size_t term) {
  Vector f = Vector::Zero(net.q.size());
  for (auto _ : bench) {
    net.cloth.system().terms()[term]->add_force(net.state(), f);
    benchmark::DoNotOptimize(f.data());
  }
  per_element(bench, net.elements(term));
}

void tangent_of_term(benchmark::State& bench, const Net& net, std::size_t term) {
  BlockMatrix matrix(net.pattern.structure, Symmetry::symmetric);
  Assembler assembler(matrix, net.pattern.tables[term]);
  for (auto _ : bench) net.cloth.system().terms()[term]->add_tangent(net.state(), -1, -600, assembler);
  per_element(bench, net.elements(term));
}

void force_of_system(benchmark::State& bench, const Net& net) {
  Vector f(net.q.size());
  for (auto _ : bench) {
    net.cloth.system().force(net.state(), f);
    benchmark::DoNotOptimize(f.data());
  }
  per_element(bench, static_cast<std::size_t>(net.q.size() / 3));
}

void tangent_of_system(benchmark::State& bench, const Net& net) {
  BlockMatrix matrix(net.cloth.system().structure(), Symmetry::symmetric);
  for (auto _ : bench) {
    matrix.set_zero();
    net.cloth.system().add_tangent(net.state(), -1, -600, matrix);
  }
  per_element(bench, static_cast<std::size_t>(net.q.size() / 3));
}

void enter(int nodes) {
  const auto net = wavy_net(nodes);
  const auto& terms = net->cloth.system().terms();
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (net->elements(k) == 0) continue;  // a load of constant forces
    std::string name(terms[k]->name());
    std::ranges::replace(name, ' ', '_');
    benchmark::RegisterBenchmark(fmt::format("force/{}/{}", name, nodes).c_str(),
                                 [net, k](benchmark::State& bench) { force_of_term(bench, *net, k); });
    benchmark::RegisterBenchmark(fmt::format("tangent/{}/{}", name, nodes).c_str(),
                                 [net, k](benchmark::State& bench) { tangent_of_term(bench, *net, k); });
  }
  benchmark::RegisterBenchmark(fmt::format("force/system_by_node/{}", nodes).c_str(),
                               [net](benchmark::State& bench) { force_of_system(bench, *net); });
  benchmark::RegisterBenchmark(fmt::format("tangent/system_by_node/{}", nodes).c_str(),
                               [net](benchmark::State& bench) { tangent_of_system(bench, *net); });
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  enter(41);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}

// Force and tangent of the shell's elements: time for each, as many at once as fill a SIMD register, and one by one,
// which is what they cost without vectorisation (the same arithmetic with all lanes but one idle). 40 × 40 cells in
// waves, damped, one thread; linear bending and the twill's polynomial.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include "sundrape/force/shell.hpp"
#include "sundrape/material/fabric.hpp"
#include "sundrape/mesh/builders.hpp"
#include "sundrape/mesh/directors.hpp"

namespace {

using namespace sundrape;

constexpr double size = 0.2, director_length = 0.0025;  // [m]
constexpr int cells = 40;

ShellSection section(const std::string& law) {
  Fabric fabric = isotropic_fabric(5.93e6, 0.3, 0.489e-3, 0.26);
  if (law != "linear") {
    // the article's fit, to SI
    std::array<double, 5> alpha{1.33387, -2.23070, 2.36510, -1.08471, 0.17876};
    double unit = 0.980665;
    for (auto& a : alpha) a *= unit *= 0.01;
    const auto strip = MomentCurvature::polynomial(alpha, 250);
    set_measured_bending(
        fabric, Fabric::MeasuredBending{strip, strip,
                                        law == "energy" ? PlateBending::Form::energy : PlateBending::Form::paper});
  }
  return {.membrane = membrane_stiffness(fabric),
          .shear = fabric.transverse_shear,
          .bending = plate_bending(fabric),
          .membrane_damping = 1e-3,
          .bending_damping = 3e-4};
}

/// A sheet in waves and in motion, as one term or as one term an element.
struct Sheet {
  std::vector<std::unique_ptr<Shell>> terms;
  Pattern::Built pattern;
  Vector q, v;

  [[nodiscard]] State state() const { return {0, q, v}; }
};

std::shared_ptr<const Sheet> wavy_sheet(const std::string& law, bool one_by_one) {
  const auto mesh = rectangle(size, size, cells, cells);
  auto sheet = std::make_shared<Sheet>();
  const int n = mesh.nodes();
  sheet->q.resize(6 * n);
  std::vector<Vector3> bent;
  const double wave_number = 2 * std::numbers::pi / 0.05;
  for (const auto& x : mesh.reference) {
    const double wave = std::sin(wave_number * x.x()) + std::cos(wave_number * (x.y() + 0.3 * x.x()));
    bent.emplace_back(x + Vector3(1e-4 * wave, -1e-4 * wave, 1.5e-3 * wave));
  }
  const auto normals = node_normals(mesh, bent);
  for (int i = 0; i < n; ++i) {
    point(sheet->q, i) = bent[static_cast<std::size_t>(i)];
    point(sheet->q, n + i) = director_length * normals[static_cast<std::size_t>(i)];
  }
  sheet->v = 0.1 * Vector::LinSpaced(6 * n, -1, 1);
  const auto elements = shell_elements(mesh, rest_directors(mesh));
  const ShellOptions options{.director_length = director_length};
  if (one_by_one)
    for (const auto& e : elements)
      sheet->terms.push_back(std::make_unique<Shell>(std::vector{e}, section(law), options));
  else
    sheet->terms.push_back(std::make_unique<Shell>(elements, section(law), options));
  std::vector<int> rows;  // a node's position and director next to each other
  for (int p = 0; p < 2 * n; ++p) rows.push_back(p < n ? 2 * p : 2 * (p - n) + 1);
  Pattern pattern(rows);
  for (const auto& term : sheet->terms) term->declare_pattern(pattern);
  sheet->pattern = pattern.build();
  return sheet;
}

void per_element(benchmark::State& bench) {
  using benchmark::Counter;
  bench.counters["per_element"] = Counter(cells * cells, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void force(benchmark::State& bench, const Sheet& sheet) {
  Vector f = Vector::Zero(sheet.q.size());
  for (auto _ : bench) {
    for (const auto& term : sheet.terms) term->add_force(sheet.state(), f);
    benchmark::DoNotOptimize(f.data());
  }
  per_element(bench);
}

void tangent(benchmark::State& bench, const Sheet& sheet, Symmetry symmetry) {
  BlockMatrix matrix(sheet.pattern.structure, symmetry);
  for (auto _ : bench) {
    matrix.set_zero();
    for (std::size_t k = 0; k < sheet.terms.size(); ++k) {
      Assembler assembler(matrix, sheet.pattern.tables[k]);
      sheet.terms[k]->add_tangent(sheet.state(), -1, -600, assembler);
    }
  }
  per_element(bench);
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  for (const std::string law : {"linear", "energy", "paper"})
    for (const bool one_by_one : {false, true}) {
      const auto sheet = wavy_sheet(law, one_by_one);
      const auto name = [&](const char* what) {
        return fmt::format("{}/{}/{}", what, law, one_by_one ? "one_by_one" : "batched");
      };
      benchmark::RegisterBenchmark(name("force").c_str(), [sheet](benchmark::State& bench) { force(bench, *sheet); });
      benchmark::RegisterBenchmark(name("tangent").c_str(),
                                   [sheet](benchmark::State& bench) { tangent(bench, *sheet, Symmetry::symmetric); });
      if (!one_by_one)
        benchmark::RegisterBenchmark(name("unsymmetric_tangent").c_str(), [sheet](benchmark::State& bench) {
          tangent(bench, *sheet, Symmetry::unsymmetric);
        });
    }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}

// What may touch: the search for pairs on a sheet folded in four layers, on finer and finer meshes, and what it is good
// for, the forces between the layers. The argument is nodes a side, the fit is to quads. One thread.
#include <cmath>
#include <memory>
#include <numbers>

#include <benchmark/benchmark.h>
#include <omp.h>

#include "sundrape/force/cloth_contact.hpp"
#include "sundrape/force/contact_law.hpp"
#include "sundrape/mesh/box_pairs.hpp"
#include "sundrape/mesh/builders.hpp"

namespace {

using namespace sundrape;

constexpr double side = 0.4, thickness = 0.5e-3, gap = 0.9 * thickness;  // [m]
constexpr int layers = 4;

/// A sheet laid in folds along x, its layers a little nearer than they rest.
struct Folded {
  QuadMesh mesh;
  Vector q;

  explicit Folded(int nodes) : mesh(rectangle(side, side, nodes - 1, nodes - 1)), q(3 * mesh.nodes()) {
    const double bend = 0.5 * gap * std::numbers::pi, straight = (side - (layers - 1) * bend) / layers;
    for (int n = 0; n < mesh.nodes(); ++n) {
      const Vector3& x = mesh.reference[static_cast<std::size_t>(n)];
      const double along = std::min(std::max(x.x() - mesh.reference[0].x(), 0.0), side - 1e-12);
      const int layer = static_cast<int>(along / (straight + bend));
      const double rest = along - layer * (straight + bend);
      const double forth = layer % 2 == 0 ? 1.0 : -1.0, middle = 0.5 * straight;
      const double turn = std::max(rest - straight, 0.0) / (0.5 * gap);  // past the straight part: around the bend
      point(q, n) = Vector3(forth * (std::min(rest, straight) - middle + 0.5 * gap * std::sin(turn)), x.y(),
                            gap * layer + 0.5 * gap * (1 - std::cos(turn)));
    }
  }
};

ClothPairs pairs_of(const Folded& cloth) { return {cloth.mesh, thickness, 4.0}; }

void boxes(benchmark::State& bench) {
  const Folded cloth(static_cast<int>(bench.range(0)));
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const auto& quad : cloth.mesh.quads) {
    Eigen::AlignedBox3d box;
    for (const int n : quad) box.extend(Vector3(point(cloth.q, n)));
    box.min().array() -= thickness;
    box.max().array() += thickness;
    boxes.push_back(box);
  }
  std::size_t found = 0;
  for (auto _ : bench) found = overlapping_pairs(boxes).size();
  bench.counters["pairs_per_quad"] = static_cast<double>(found) / static_cast<double>(boxes.size());
  bench.SetComplexityN(static_cast<benchmark::IterationCount>(boxes.size()));
}

void pairs(benchmark::State& bench) {
  const Folded cloth(static_cast<int>(bench.range(0)));
  const auto search = pairs_of(cloth);
  std::size_t found = 0;
  for (auto _ : bench) found = search.within(2 * thickness, cloth.q).size();
  bench.counters["pairs_per_quad"] = static_cast<double>(found) / static_cast<double>(cloth.mesh.quads.size());
  bench.SetComplexityN(static_cast<benchmark::IterationCount>(cloth.mesh.quads.size()));
}

void forces(benchmark::State& bench) {
  const Folded cloth(static_cast<int>(bench.range(0)));
  const ClothContact contact(pairs_of(cloth), ContactLaw(1e7, 0.1 * thickness), {});
  const Vector still = Vector::Zero(cloth.q.size());
  Vector f = Vector::Zero(cloth.q.size());
  for (auto _ : bench) {
    contact.add_force({0, cloth.q, still}, f);
    benchmark::DoNotOptimize(f.data());
  }
  bench.counters["contacts"] = contact.report({0, cloth.q, still}).contacts;
  bench.SetComplexityN(static_cast<benchmark::IterationCount>(cloth.mesh.quads.size()));
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int nodes : {21, 41, 81, 161}) bench->Arg(nodes);
  bench->Unit(benchmark::kMillisecond)->Complexity(benchmark::oNLogN);
}

BENCHMARK(boxes)->Apply(sizes);
BENCHMARK(pairs)->Apply(sizes);
BENCHMARK(forces)->Apply(sizes);

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}

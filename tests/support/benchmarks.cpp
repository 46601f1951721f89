#include "support/benchmarks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "sundrape/integrate/dynamics.hpp"
#include "sundrape/integrate/stability_limit.hpp"
#include "sundrape/io/case_reader.hpp"

namespace sundrape {
namespace {

class Frames final : public DynamicsObserver {
 public:
  explicit Frames(Motion& motion) : motion_(motion) {}
  void frame(const State& all, const EnergyAudit::Balance& balance) override {
    const double energy = balance.energies.total();
    if (motion_.time.empty()) motion_.energy_start = energy;
    motion_.energy_end = energy;
    motion_.method_dissipated = balance.method_dissipated;
    motion_.dissipated = balance.dissipated;
    motion_.largest_energy = std::max(motion_.largest_energy, energy - motion_.energy_start);
    motion_.time.push_back(all.time);
    motion_.position.emplace_back(all.q);
  }
  void step(const State&, const StepReport&, const Integrator&) override {}
  [[nodiscard]] bool wants_to_stop() override { return false; }

 private:
  Motion& motion_;
};

class Silent final : public RelaxationObserver {
 public:
  void step(const State&, const RelaxationStep&) override {}
  [[nodiscard]] bool wants_to_stop() override { return false; }
};

}  // namespace

Benchmark benchmark(const std::string& case_name, const std::vector<std::string>& sets) {
  Case c = read_case(std::filesystem::path(SUNDRAPE_SOURCE_DIR) / "cases" / case_name, sets);
  CaseModel model = build_model(c);
  return {std::move(c), std::move(model)};
}

Vector equilibrium(const Benchmark& b, double tolerance) {
  Vector q = b.model.initial;
  Silent silent;
  const auto solver = make_linear_solver(SolverKind::cholesky);
  const double swing = std::sqrt(b.model.size / b.model.gravity);
  const auto result = relax(*b.model.system, *solver, {.tolerance = tolerance, .first_step = b.c.relaxation.first_step.value_or(0.01 * swing), .growth = b.c.relaxation.growth}, q, silent);
  EXPECT_EQ(result.end, RelaxationEnd::converged) << result.diagnosis;
  return q;
}

Motion motion(const Benchmark& b) {
  const auto& d = b.c.dynamics;
  IntegratorOptions options;
  options.rtol = d.rtol;
  options.atol_position = d.atol_position.value_or(0.1 * d.rtol * b.model.size);
  options.atol_velocity = d.atol_velocity.value_or(std::min(0.01, 100 * d.rtol) * std::sqrt(b.model.gravity * b.model.size));
  options.max_order = d.max_order;
  options.fixed_step = d.step.value_or(0);
  std::unique_ptr<Integrator> integrator;
  if (d.integrator == IntegratorKind::cvode) integrator = make_cvode(*b.model.system, make_linear_solver(SolverKind::conjugate_gradients), options);
  if (d.integrator == IntegratorKind::ida) integrator = make_ida(*b.model.system, make_linear_solver(SolverKind::conjugate_gradients), options);
  if (d.integrator == IntegratorKind::rk4) integrator = make_rk4(*b.model.system, options);
  Motion motion;
  Frames frames(motion);
  Dynamics dynamics(*b.model.system, *integrator, b.c.output.frame_times, frames);
  dynamics.run(0, b.model.initial, Vector::Zero(b.model.initial.size()), true);
  motion.statistics = integrator->statistics();
  return motion;
}

std::map<std::string, std::vector<double>> reference_table(const std::string& name) {
  std::ifstream in(std::filesystem::path(SUNDRAPE_SOURCE_DIR) / "tests" / "reference" / name);
  EXPECT_TRUE(in) << name;
  std::map<std::string, std::vector<double>> table;
  std::vector<std::string> header;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells(line);
    std::size_t k = 0;
    const bool names = header.empty();
    for (std::string cell; std::getline(cells, cell, ','); ++k) {
      if (names)
        header.push_back(cell);
      else
        table[header.at(k)].push_back(std::stod(cell));
    }
  }
  return table;
}

}  // namespace sundrape

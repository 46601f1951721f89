#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sundrape/app/model.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

/// A case from cases/ (by file name) with settings, built.
struct Benchmark {
  Case c;
  CaseModel model;
};
[[nodiscard]] Benchmark benchmark(const std::string& case_name, const std::vector<std::string>& sets = {});

/// Its equilibrium by relaxation: positions of all nodes (3N). Fails the test if it does not converge.
[[nodiscard]] Vector equilibrium(const Benchmark& b, double tolerance = 1e-6);

/// Positions at the frame times of a dynamic case, and what the integrator did.
struct Motion {
  std::vector<double> time;
  std::vector<Vector> position;
  IntegratorStatistics statistics;
  double energy_start = 0, energy_end = 0, method_dissipated = 0, dissipated = 0;
  double largest_energy = 0;   // over frames, of kinetic + stored − initial [J]
};
[[nodiscard]] Motion motion(const Benchmark& b);

/// Columns of a reference table (CSV with # comments), by header name.
[[nodiscard]] std::map<std::string, std::vector<double>> reference_table(const std::string& name);

}  // namespace sundrape

// Energy of the undamped swing (B9): physics keeps it, the integration method does not.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

struct Drift {
  double largest;  // |E(t) − E(0)| over the frames, over the largest kinetic energy
  double allowed;  // by the error weights
};

/// The error test lets a rate err by a = min(0.01, 100 rtol) √(g L) a step, that is, the energy by about m v a where
/// the strip falls with v ≈ √(2 g L): 2 a / v of its kinetic energy. Errors of either sign add up as √steps.
double allowed_drift(double rtol, long steps) {
  return std::sqrt(2.0) * std::min(0.01, 100 * rtol) * std::sqrt(static_cast<double>(steps));
}

const std::string net = "swing.toml", shell = "swing_shell.toml";

Drift drift(const std::string& name, const std::string& integrator, int cells, const std::string& rtol) {
  const auto m =
      motion(benchmark(name, {cells_along(cells), "dynamics.rtol=" + rtol, "dynamics.integrator=" + integrator}));
  const double scale = *std::ranges::max_element(m.kinetic);
  Drift d{0, allowed_drift(std::stod(rtol), m.statistics.steps)};
  for (const double e : m.energy) d.largest = std::max(d.largest, std::abs(e - m.energy.front()) / scale);
  fmt::print(
      "{} {:5} rtol {}: largest |drift| {:.2e} of the largest kinetic energy (allowed {:.1e}), at 0.3 s {:+.2e}; {} "
      "steps\n",
      name, integrator, rtol, d.largest, d.allowed, (m.energy.back() - m.energy.front()) / scale, m.statistics.steps);
  return d;
}

TEST(EnergyDrift, StaysWithinWhatTheErrorWeightsAllow) {
  for (const auto& name : {net, shell})
    for (const char* integrator : {"cvode", "ida", "dirk"}) {
      const auto d = drift(name, integrator, 20, "1e-5");
      EXPECT_LT(d.largest, d.allowed) << name << ", " << integrator;
    }
}

TEST(EnergyDriftVerification, FallsWithTheToleranceAndStaysWithinWhatTheErrorWeightsAllow) {
  for (const auto& name : {net, shell})
    for (const char* integrator : {"cvode", "ida", "dirk"}) {
      std::map<std::string, double> largest;
      for (const std::string rtol : {"1e-3", "1e-4", "1e-5", "1e-6", "1e-7"}) {
        const auto d = drift(name, integrator, 40, rtol);
        EXPECT_LT(d.largest, d.allowed) << name << ", " << integrator << ", rtol " << rtol;
        largest[rtol] = d.largest;
      }
      // 1e-3 and 1e-4 bound the rates' error alike
      EXPECT_LT(largest["1e-5"], largest["1e-4"]) << name << ", " << integrator;
      EXPECT_LT(largest["1e-6"], largest["1e-5"]) << name << ", " << integrator;
      EXPECT_LT(largest["1e-7"], largest["1e-6"]) << name << ", " << integrator;
    }
}

}  // namespace
}  // namespace sundrape

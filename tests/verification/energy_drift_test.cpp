// Energy of the undamped swing (B9): physics keeps it, the integration method does not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

struct Drift {
  double largest;      // |E(t) − E(0)| over the frames, over the largest kinetic energy
  double last;         // E(0.3 s) − E(0), likewise
  double steps, rtol;
};

Drift drift(const std::string& integrator, int cells, const std::string& rtol) {
  const auto m = motion(
      benchmark("swing.toml", {cells_along(cells), "dynamics.rtol=" + rtol, "dynamics.integrator=" + integrator}));
  const double scale = *std::ranges::max_element(m.kinetic);
  Drift d{0, (m.energy.back() - m.energy.front()) / scale, static_cast<double>(m.statistics.steps), std::stod(rtol)};
  for (const double e : m.energy) d.largest = std::max(d.largest, std::abs(e - m.energy.front()) / scale);
  fmt::print("{:5} rtol {}: largest |drift| {:.2e}, at 0.3 s {:+.2e}, {} steps\n", integrator, rtol, d.largest, d.last,
             m.statistics.steps);
  return d;
}

// A step may err by rtol; if every one erred to the same side, the energy would have drifted by steps × rtol.

TEST(EnergyDrift, StaysBelowOneToleranceAStep) {
  for (const char* integrator : {"cvode", "ida"}) {
    const auto d = drift(integrator, 20, "1e-5");
    EXPECT_LT(d.largest, d.steps * d.rtol) << integrator;
  }
}

TEST(EnergyDriftVerification, FallsWithTheToleranceAndStaysBelowOneToleranceAStep) {
  for (const char* integrator : {"cvode", "ida"}) {
    double before = drift(integrator, 40, "1e-3").largest;   // too loose to promise anything without damping
    for (const char* rtol : {"1e-4", "1e-5", "1e-6"}) {
      const auto d = drift(integrator, 40, rtol);
      EXPECT_LT(d.largest, before) << integrator << ", rtol " << rtol;
      EXPECT_LT(d.largest, d.steps * d.rtol) << integrator << ", rtol " << rtol;
      before = d.largest;
    }
  }
}

}  // namespace
}  // namespace sundrape

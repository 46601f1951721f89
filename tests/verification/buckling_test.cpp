#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/traced_path.hpp"

namespace sundrape {
namespace {

constexpr double gf = 9.80665e-3;              // [N]
constexpr double bending = 0.589 * gf * 1e-2;  // B of the twill per width [N m]
constexpr double weight = 0.02665 * gf * 1e4;  // w [N/m²]

/// Load factor at which a path first loses its stability.
double first_bifurcation(const TracedPath& path) {
  EXPECT_EQ(path.result.end, PathEnd::complete) << path.result.diagnosis;
  if (path.critical.empty() || path.critical[0].kind != CriticalPoint::Kind::bifurcation) {
    ADD_FAILURE() << "no bifurcation was found";
    return 0;
  }
  EXPECT_EQ(path.critical[0].pivots_before, 0);
  EXPECT_GT(path.critical[0].pivots_after, 0);
  return path.critical[0].load_factor;
}

struct Model {
  const char* name;
  bool shell;
};
void PrintTo(const Model& model, std::ostream* out) { *out << model.name; }

class Buckling : public testing::TestWithParam<Model> {
 protected:
  [[nodiscard]] static std::string model() { return std::string("model=") + GetParam().name; }
};

// Euler: π² EI/(4 L²) of a strip clamped at one end.
TEST_P(Buckling, StripUnderEndThrustIsWithinHalfAPercentOfEuler) {
  const double load = 0.02 * gf / 1e-2, length = 0.1;  // the case's full traction [N/m]
  const double exact = std::pow(std::numbers::pi / (2 * length), 2) * bending / load;
  const double found = first_bifurcation(trace(benchmark("euler_strut.toml", {model()})));
  fmt::print("  Euler {}: load factor {:.6f}, exact {:.6f}, {:+.3f} %\n", GetParam().name, found, exact,
             100 * (found / exact - 1));
  EXPECT_NEAR(found, exact, 0.005 * exact);
}

// Greenhill: w L³/B = 7.8373, the first zero of J_{−1/3} at 1.86635 (9/4 of its square).
TEST_P(Buckling, StandingStripIsWithinOnePercentOfGreenhill) {
  const double length = 0.06, zero = 1.866350858873895;
  const double exact = 2.25 * zero * zero * bending / (weight * std::pow(length, 3));
  const double found = first_bifurcation(trace(benchmark("greenhill.toml", {model()})));
  fmt::print("  Greenhill {}: load factor {:.6f}, exact {:.6f}, {:+.3f} %\n", GetParam().name, found, exact,
             100 * (found / exact - 1));
  EXPECT_NEAR(found, exact, 0.01 * exact);
}

INSTANTIATE_TEST_SUITE_P(Of, Buckling, testing::Values(Model{"particle", false}, Model{"shell", true}),
                         [](const auto& info) { return std::string(info.param.name); });

// The bent strip beyond Euler's load: P/P_cr = (2 K(k)/π)², tip at L (2 E(k)/K(k) − 1) along and 2 k L/K(k) across (the
// elastica in elliptic integrals, e.g. Timoshenko & Gere, Theory of Elastic Stability, §2.7).
TEST(BucklingBranch, IsTheElasticaToEitherSide) {
  const double load = 0.02 * gf / 1e-2, length = 0.1;
  const double critical = std::pow(std::numbers::pi / (2 * length), 2) * bending;
  for (const double side : {1.0, -1.0}) {
    const auto b = benchmark("euler_strut.toml", {"arc-length.at_bifurcation=switch",
                                                  fmt::format("arc-length.branch_amplitude={} mm", side)});
    const auto path = trace(b);
    ASSERT_EQ(path.result.end, PathEnd::complete) << path.result.diagnosis;
    int compared = 0;
    double direction = 0;
    for (const auto& step : path.steps) {
      const auto line = centre_line(b.model.mesh, b.model.of_nodes(step.q));
      const double along = (line.back().x() - line.front().x()) / length, across = line.back().z() / length;
      const double ratio = step.load_factor * load / critical;
      if (std::abs(across) < 0.05) continue;
      double low = 0, high = 0.999;  // K(k) grows with k
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (std::pow(2 * std::comp_ellint_1(middle) / std::numbers::pi, 2) < ratio ? low : high) = middle;
      }
      const double big_k = std::comp_ellint_1(low), big_e = std::comp_ellint_2(low);
      // 40 elements: a load that is 0.03 % too high moves the tip by up to 0.5 % of L where the branch is flat
      EXPECT_NEAR(along, 2 * big_e / big_k - 1, 0.005) << "P/P_cr = " << ratio;
      EXPECT_NEAR(std::abs(across), 2 * low / big_k, 0.005) << "P/P_cr = " << ratio;
      EXPECT_EQ(step.report.negative_pivots, 0);
      direction = across;
      ++compared;
    }
    EXPECT_GE(compared, 5);
    EXPECT_NE(direction, 0);
  }
}

}  // namespace
}  // namespace sundrape

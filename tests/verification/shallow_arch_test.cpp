#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/pinned_arch.hpp"
#include "support/traced_path.hpp"

namespace sundrape {
namespace {

constexpr double thickness = 2e-3, width = 0.01, modulus = 3e9, load = 10;  // of shallow_arch.toml
const PinnedArch arch{0.5, 0.1177, modulus* width* thickness, modulus* width* thickness* thickness* thickness / 12};

class ShallowArch : public testing::TestWithParam<const char*> {};

// Independent: the extensible elastica of the arch, by shooting (tests/support/pinned_arch.hpp).
TEST_P(ShallowArch, SnapsThroughAndBackAtTheLoadsOfTheBeam) {
  const auto b = benchmark("shallow_arch.toml", {std::string("model=") + GetParam()});
  const auto path = trace(b);
  ASSERT_EQ(path.result.end, PathEnd::complete) << path.result.diagnosis;
  const auto [upper, lower] = arch.limits();
  std::vector<double> limits[2];
  for (const auto& point : path.critical)
    if (point.kind == CriticalPoint::Kind::limit_point) {
      const double share = point.stage == 1 ? point.load_factor : 1 - 2 * point.load_factor;
      limits[point.stage - 1].push_back(share * load);
    }
  ASSERT_EQ(limits[0].size(), 2U);
  ASSERT_EQ(limits[1].size(), 2U);
  fmt::print("  {}: down {:.4f} and {:.4f} N, up {:.4f} and {:.4f} N; beam {:.4f} and {:.4f} N\n", GetParam(),
             limits[0][0], limits[0][1], limits[1][0], limits[1][1], upper, lower);
  // the stiffness of a mode of three half waves over 40 cells is off by (3π/40)²/12 = 0.46 %: twice that
  EXPECT_NEAR(limits[0][0], upper, 0.01 * upper);
  EXPECT_NEAR(limits[0][1], lower, -0.01 * lower);
  EXPECT_NEAR(limits[1][0], limits[0][1], 2e-3 * upper);  // the same path, walked back
  EXPECT_NEAR(limits[1][1], limits[0][0], 2e-3 * upper);
}

TEST_P(ShallowArch, FollowsTheBeamsLoadDisplacementCurve) {
  const auto b = benchmark("shallow_arch.toml", {std::string("model=") + GetParam()});
  const auto path = trace(b);
  const int crown = b.model.probes.front().node;
  std::vector<double> heights;
  for (int k = 0; k <= 380; ++k) heights.push_back(arch.rise() * (1 - 0.005 * k));
  const auto forces = arch.forces(heights, 100);
  int compared = 0;
  for (const auto& step : path.steps) {
    const double height = step.q[3 * crown + 2];
    if (step.stage != 1 || height < heights.back() || height > heights.front()) continue;
    const double place = (arch.rise() - height) / (0.005 * arch.rise());
    const auto k = std::min(static_cast<std::size_t>(place), heights.size() - 2);
    const double part = place - static_cast<double>(k);
    const double expected = (1 - part) * forces[k] + part * forces[k + 1];
    EXPECT_NEAR(step.load_factor * load, expected, 0.01 * 6.5) << "height " << height;
    ++compared;
  }
  EXPECT_GE(compared, 15);
}

INSTANTIATE_TEST_SUITE_P(Of, ShallowArch, testing::Values("particle", "shell"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace sundrape

#include "sundrape/mesh/waviness.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

TEST(Waviness, MovesNodesAlongTheNormalWithinTheAmplitude) {
  const auto mesh = rectangle(0.2, 0.2, 20, 20);
  auto tilted = mesh.reference;
  for (auto& x : tilted) x.z() = 0.75 * x.x();
  const auto moved = wavy(mesh, tilted, 1e-4, 1);
  double lowest = 1, highest = -1, sum = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Vector3 shift = moved[i] - tilted[i];
    const double height = shift.dot(Vector3(-0.6, 0, 0.8));
    EXPECT_LT((shift - height * Vector3(-0.6, 0, 0.8)).norm(), 1e-15);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    sum += height;
  }
  EXPECT_LE(highest, 1e-4);
  EXPECT_GE(lowest, -1e-4);
  EXPECT_GT(highest, 0.95e-4);
  EXPECT_LT(lowest, -0.95e-4);
  // the mean of 441 uniform heights has a standard deviation of 1e-4 / √(3 · 441)
  EXPECT_LT(std::abs(sum / 441), 4e-4 / std::sqrt(3.0 * 441));
}

TEST(Waviness, DependsOnTheSeedAlone) {
  const auto mesh = rectangle(0.2, 0.2, 4, 4);
  EXPECT_EQ(wavy(mesh, mesh.reference, 1e-4, 7), wavy(mesh, mesh.reference, 1e-4, 7));
  EXPECT_NE(wavy(mesh, mesh.reference, 1e-4, 7), wavy(mesh, mesh.reference, 1e-4, 8));
  EXPECT_EQ(wavy(mesh, mesh.reference, 0, 7), mesh.reference);
}

TEST(Waviness, IsTheSameOnEveryPlatform) {
  // The C++ standard fixes mt19937_64's first number for its default seed 5489: 14514284786278117030.
  const auto mesh = rectangle(0.2, 0.2, 1, 1);
  const double fraction = static_cast<double>(14514284786278117030ULL >> 11U) / 9007199254740992.0;
  EXPECT_DOUBLE_EQ(wavy(mesh, mesh.reference, 1.0, 5489)[0].z(), 2 * fraction - 1);
}

TEST(Waviness, RefusesANegativeAmplitude) {
  const auto mesh = rectangle(0.2, 0.2, 1, 1);
  EXPECT_THROW((void)wavy(mesh, mesh.reference, -1e-4, 1), std::invalid_argument);
  EXPECT_THROW((void)wavy(mesh, mesh.reference, std::nan(""), 1), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

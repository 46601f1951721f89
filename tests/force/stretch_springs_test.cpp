#include "sundrape/force/stretch_springs.hpp"

#include <gtest/gtest.h>

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

StretchSprings crossed_pair(double compression_factor, double relaxation_time) {
  return {{{0, 1, 0.012, 640}, {1, 2, 0.009, 320}, {3, 0, 0.011, 100}},
          EnergyKind::membrane,
          relaxation_time,
          compression_factor};
}

TEST(StretchSprings, ForceIsTheGradientOfTheEnergyAndTheTangentIsExact) {
  for (const double factor : {1.0, 0.2, 0.0})
    for (const double time : {0.0, 1e-3})
      expect_consistent(crossed_pair(factor, time), random_state(4, /*seed=*/7), /*relative=*/1e-6);
}

TEST(StretchSprings, RigidMotionLeavesThemAtRest) {
  const std::vector<Vector3> rest{{0, 0, 0}, {0.012, 0, 0}, {0.012, 0.009, 0}, {0, 0, 0.011}};
  expect_no_force_under_rigid_motion(crossed_pair(1.0, 1e-3), rest, /*force_scale=*/640 * 0.012);
}

TEST(StretchSprings, ForcesAndMomentsBalance) { expect_self_equilibrated(crossed_pair(0.5, 1e-3), random_state(4, 3)); }

TEST(StretchSprings, DampingTakesTheEnergyItReports) {
  expect_dissipates_what_it_says(crossed_pair(1.0, 1e-3), random_state(4, 5));
}

TEST(StretchSprings, HangingThreadStretchesByItsWeight) {
  // chapter (38): a spring of E h w = 6.4 N carrying 0.064 N lengthens by 1 %
  const StretchSprings thread({{0, 1, 0.01, 6.4 / 0.01}}, EnergyKind::membrane);
  Vector q(6), v = Vector::Zero(6), f = Vector::Zero(6);
  q << 0, 0, 0, 0, 0, -0.0101;
  thread.add_force({0, q, v}, f);
  EXPECT_NEAR(f[5], 0.064, 1e-12);
}

TEST(StretchSprings, CompressionIsSofterByItsFactor) {
  Vector q(6), v = Vector::Zero(6), whole = Vector::Zero(6), part = Vector::Zero(6);
  q << 0, 0, 0, 0.0099, 0, 0;
  StretchSprings({{0, 1, 0.01, 640}}, EnergyKind::membrane, 0, 1).add_force({0, q, v}, whole);
  StretchSprings({{0, 1, 0.01, 640}}, EnergyKind::membrane, 0, 0.25).add_force({0, q, v}, part);
  EXPECT_NEAR(part[3], 0.25 * whole[3], 1e-15);
  EXPECT_GT(whole[3], 0);  // pushes the shortened ends apart
}

TEST(StretchSprings, RefuseWhatIsNoSpring) {
  EXPECT_THROW(StretchSprings({{0, 1, 0.0, 640}}, EnergyKind::membrane), std::invalid_argument);
  EXPECT_THROW(StretchSprings({{0, 1, 0.01, 0}}, EnergyKind::membrane), std::invalid_argument);
  EXPECT_THROW(StretchSprings({{0, 1, 0.01, 640}}, EnergyKind::membrane, -1), std::invalid_argument);
  EXPECT_THROW(StretchSprings({{0, 1, 0.01, 640}}, EnergyKind::membrane, 0, 1.5), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

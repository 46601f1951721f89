#include "sundrape/force/friction_law.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

constexpr double speed = 1e-3;

double part(double s) { return FrictionLaw(speed).over_speed(s) * s; }

TEST(FrictionLaw, IsFullAboveItsSpeedAndOneMinusTheCubeBelow) {
  EXPECT_DOUBLE_EQ(part(speed), 1);
  EXPECT_DOUBLE_EQ(part(50 * speed), 1);
  for (const double x : {0.1, 0.5, 0.9}) EXPECT_NEAR(part(x * speed), 1 - std::pow(1 - x, 3), 1e-15);
  EXPECT_DOUBLE_EQ(FrictionLaw(speed).over_speed(0), 3 / speed);
}

TEST(FrictionLaw, SlopeIsTheDerivative) {
  const FrictionLaw law(speed);
  for (const double s : {0.2 * speed, 0.8 * speed, 1.5 * speed, 40 * speed}) {
    const double h = 1e-4 * s;
    const double expected = (law.over_speed(s + h) - law.over_speed(s - h)) / (2 * h) / s;
    EXPECT_NEAR(law.slope_over_speed(s), expected, 1e-6 * std::abs(expected));
  }
  EXPECT_EQ(law.slope_over_speed(0), 0);
}

TEST(FrictionLaw, RefusesNoSpeed) { EXPECT_THROW(FrictionLaw(0), std::invalid_argument); }

}  // namespace
}  // namespace sundrape

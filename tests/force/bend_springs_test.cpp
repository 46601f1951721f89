#include "sundrape/force/bend_springs.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/force/clamp_springs.hpp"
#include "sundrape/force/hinge_angle.hpp"

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

constexpr double b = 0.01, stiffness = 4e-5;  // [m], [N m]
// a cross of threads: 0 – 1 – 2 along x, 3 and 4 across
const std::vector<Vector3> cross{{-b, 0, 0}, {0, 0, 0}, {b, 0, 0}, {0, -b, 0}, {0, b, 0}};

BendSprings inside(double relaxation_time, double skew = 0, double rest = 0) {
  return BendSprings({{.previous = 0,
                       .centre = 1,
                       .next = 2,
                       .cross_from = 3,
                       .cross_to = 4,
                       .skew = skew,
                       .rest_angle = rest,
                       .stiffness = stiffness}},
                     relaxation_time);
}
BendSprings on_boundary(double relaxation_time) {
  return BendSprings(
      {{.previous = 0, .centre = 1, .next = 2, .cross_from = 1, .cross_to = 4, .stiffness = stiffness},
       {.previous = 0, .centre = 1, .next = 2, .cross_from = 3, .cross_to = 1, .stiffness = 0.5 * stiffness}},
      relaxation_time);
}

TEST(BendSprings, ForceIsTheGradientOfTheEnergyAndTheTangentIsExact) {
  for (const double time : {0.0, 3e-4}) {
    expect_consistent(inside(time), perturbed(cross, 0.4 * b, 0.2, 3), 1e-6);
    expect_consistent(inside(time, 0.3, 0.2), perturbed(cross, 0.4 * b, 0.2, 5), 1e-6);
    expect_consistent(on_boundary(time), perturbed(cross, 0.3 * b, 0.2, 9), 1e-6);
  }
}

TEST(BendSprings, RigidMotionLeavesThemAtRest) {
  expect_no_force_under_rigid_motion(inside(3e-4), cross, stiffness / b);
  expect_no_force_under_rigid_motion(on_boundary(3e-4), cross, stiffness / b);
}

TEST(BendSprings, ForcesAndMomentsBalance) {
  expect_self_equilibrated(on_boundary(3e-4), perturbed(cross, 0.3 * b, 0.2, 8));
}

TEST(BendSprings, DampingTakesTheEnergyItReports) {
  expect_dissipates_what_it_says(inside(3e-4), perturbed(cross, 0.3 * b, 0.2, 6));
}

TEST(BendSprings, StoreHalfTheStiffnessTimesTheAngleSquaredUpToASharpFold) {
  const Vector zero = Vector::Zero(15);
  for (const double turn : {0.1, 1.0, 2.6}) {
    Vector q(15);
    q << -b, 0, 0, 0, 0, 0, b * std::cos(turn), 0, b * std::sin(turn), 0, -b, 0, 0, b, 0;
    EXPECT_NEAR(inside(0).energy({0, q, zero}), 0.5 * stiffness * turn * turn, 1e-12 * stiffness);
    EXPECT_NEAR(inside(0).largest_angle(q), turn, 1e-12);
  }
}

TEST(BendSprings, TurningAThreadInTheSheetIsNoBending) {
  Vector q(15), zero = Vector::Zero(15);
  q << -b, 0, 0, 0, 0, 0, b * std::cos(0.4), b * std::sin(0.4), 0, 0, -b, 0, 0, b, 0;
  EXPECT_NEAR(inside(0).energy({0, q, zero}), 0, 1e-30);
}

TEST(BendSprings, RefuseASpringThatNamesANodeTwice) {
  EXPECT_THROW(BendSprings({{.previous = 0, .centre = 1, .next = 0, .cross_from = 3, .cross_to = 4, .stiffness = 1}}),
               std::invalid_argument);
  EXPECT_THROW(BendSprings({{.previous = 0, .centre = 1, .next = 2, .cross_from = 3, .cross_to = 4, .stiffness = 0}}),
               std::invalid_argument);
}

TEST(ClampSprings, ForceIsTheGradientOfTheEnergyAndTheTangentIsExact) {
  const ClampSprings clamp({{.node = 0, .next = 1, .direction = {1, 0, 0}, .axis = {0, 1, 0}, .stiffness = stiffness}},
                           3e-4);
  expect_consistent(clamp, perturbed({{0, 0, 0}, {b, 0, 0}}, 0.4 * b, 0.2, 3), 1e-6);
  expect_dissipates_what_it_says(clamp, perturbed({{0, 0, 0}, {b, 0, 0}}, 0.4 * b, 0.2, 3));
}

TEST(ClampSprings, HoldTheSlope) {
  const ClampSprings clamp({{.node = 0, .next = 1, .direction = {1, 0, 0}, .axis = {0, 1, 0}, .stiffness = stiffness}});
  Vector q(6), zero = Vector::Zero(6), f = Vector::Zero(6);
  const double turn = 0.3;
  q << 0, 0, 0, b * std::cos(turn), 0, b * std::sin(turn);
  EXPECT_NEAR(clamp.energy({0, q, zero}), 0.5 * stiffness * turn * turn, 1e-15);
  clamp.add_force({0, q, zero}, f);
  EXPECT_NEAR(f.tail<3>().norm(), stiffness * turn / b, 1e-12);  // M = F b, chapter (44)
  EXPECT_LT(f[5], 0);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/force/bend_law.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sundrape/force/bend_springs.hpp"
#include "sundrape/force/clamp_springs.hpp"

#include "support/force_term_checks.hpp"
#include "support/twill.hpp"

namespace sundrape {
namespace {

constexpr double b = 0.01, width = 0.004, damping = 3e-4;  // [m], [m], [s]
// with springs of this length, turns of half a radian are curvatures well inside and well past the fit
constexpr double inside = b, past = b / 10;
const std::vector<Vector3> cross{{-b, 0, 0}, {0, 0, 0}, {b, 0, 0}, {0, -b, 0}, {0, b, 0}};
const std::vector<Vector3> clamped_edge{{0, 0, 0}, {b, 0, 0}};

BendSpring spring(double length, double rest_angle = 0) {
  return {.previous = 0,
          .centre = 1,
          .next = 2,
          .cross_from = 3,
          .cross_to = 4,
          .rest_angle = rest_angle,
          .stiffness = twill::alpha[0] * width / length,
          .length = length};
}
BendSprings bend(double length, double relaxation_time = 0) {
  return BendSprings({spring(length)}, relaxation_time, twill::law());
}
ClampSprings clamp(double length, double relaxation_time = 0) {
  return ClampSprings({{.node = 0,
                        .next = 1,
                        .direction = {1, 0, 0},
                        .axis = {0, 1, 0},
                        .stiffness = twill::alpha[0] * width / length,
                        .length = length}},
                      relaxation_time, twill::law());
}

/// The cross with its second edge turned downwards about the crossing thread, at rest.
TestState turned(double angle) {
  TestState s{.q = Vector(15), .v = Vector::Zero(15)};
  s.q << -b, 0, 0, 0, 0, 0, b * std::cos(angle), 0, -b * std::sin(angle), 0, -b, 0, 0, b, 0;
  return s;
}
TestState turned_edge(double angle) {
  TestState s{.q = Vector(6), .v = Vector::Zero(6)};
  s.q << 0, 0, 0, b * std::cos(angle), 0, -b * std::sin(angle);
  return s;
}
/// Moment with which node `next`, one edge away from its hinge, is turned back.
double moment(const ForceTerm& term, const TestState& state, double angle, int next) {
  Vector f = Vector::Zero(state.q.size());
  term.add_force(state, f);
  return b * point(f, next).dot(Vector3(std::sin(angle), 0, std::cos(angle)));
}

TEST(BendLaw, ForceIsTheGradientOfTheEnergyAndTheTangentIsExactInsideTheFitAndPastIt) {
  for (const double time : {0.0, damping})
    for (const double length : {inside, past})
      for (const unsigned seed : {3U, 5U, 9U}) {
        const auto state = perturbed(cross, 0.4 * b, 0.2, seed);
        const double curvature = bend(length).largest_angle(state.q) / length;
        if (length == past)
          EXPECT_GT(curvature, twill::max_curvature);
        else
          EXPECT_LT(curvature, twill::max_curvature);
        expect_consistent(bend(length, time), state, 1e-6);
        expect_consistent(clamp(length, time), perturbed(clamped_edge, 0.4 * b, 0.2, seed), 1e-6);
      }
}

TEST(BendLaw, SpringsStoreWhatTheLawIntegratesToOverTheirWidthAndLength) {
  for (const double length : {inside, past})
    for (const double angle : {-2.0, -0.3, -0.01, 0.01, 0.3, 1.2, 2.6}) {
      const double stored = width * length * twill::energy(angle / length);
      EXPECT_NEAR(bend(length).energy(turned(angle)), stored, 1e-12 * stored) << angle;
      EXPECT_NEAR(clamp(length).energy(turned_edge(angle)), stored, 1e-12 * stored) << angle;
    }
}

TEST(BendLaw, SpringsCarryTheMomentOfTheirWidthAndBothWaysTheSame) {
  for (const double angle : {0.01, 0.3, 1.2, 2.4}) {
    const double carried = width * twill::moment(angle / inside);
    for (const double sign : {1.0, -1.0}) {
      EXPECT_NEAR(moment(bend(inside), turned(sign * angle), sign * angle, 2), sign * carried, 1e-12 * carried);
      EXPECT_NEAR(moment(clamp(inside), turned_edge(sign * angle), sign * angle, 1), sign * carried, 1e-12 * carried);
    }
  }
}

TEST(BendLaw, EveryLaneOfABatchFollowsIt) {
  // the same turn from different rest angles: curvatures of both signs, inside the fit and past it
  constexpr double angle = 0.2;
  std::vector<BendSpring> springs;
  double stored = 0;
  for (int k = 0; k < 19; ++k) {
    const double rest = 0.1 * (k - 9);
    springs.push_back(spring(past, rest));
    stored += width * past * twill::energy((angle - rest) / past);
  }
  const BendSprings all(springs, 0, twill::law());
  EXPECT_NEAR(all.energy(turned(angle)), stored, 1e-12 * stored);
  expect_consistent(all, perturbed(cross, 0.2 * b, 0.2, 4), 1e-6);
}

TEST(BendLaw, APolynomialOfOneTermIsTheLinearSpring) {
  const std::array one{twill::alpha[0]};
  const BendSprings linear({spring(past)}, damping);
  for (const auto& law : {MomentCurvature::linear(one[0]), MomentCurvature::polynomial(one, 100)}) {
    const BendSprings same({spring(past)}, damping, law);
    const auto state = perturbed(cross, 0.4 * b, 0.2, 3);
    EXPECT_NEAR(same.energy(state), linear.energy(state), 1e-14 * linear.energy(state));
    Vector expected = Vector::Zero(15), f = expected;
    linear.add_force(state, expected);
    same.add_force(state, f);
    EXPECT_LE((f - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(BendLaw, DampingKeepsTheRigidityOfTheOrigin) {
  const auto state = perturbed(cross, 0.4 * b, 0.2, 6);
  const auto edge = perturbed(clamped_edge, 0.4 * b, 0.2, 6);
  expect_dissipates_what_it_says(bend(inside, damping), state);
  expect_dissipates_what_it_says(clamp(inside, damping), edge);
  EXPECT_EQ(bend(inside, damping).dissipated_power(state),
            BendSprings({spring(inside)}, damping).dissipated_power(state));
}

TEST(BendLaw, RigidMotionLeavesSpringsAtRest) {
  expect_no_force_under_rigid_motion(bend(past, damping), cross, twill::alpha[0] * width / (past * b));
}

TEST(BendLaw, NeedsTheLengthOfItsSprings) {
  EXPECT_THROW(BendSprings({spring(inside),
                            {.previous = 0, .centre = 1, .next = 2, .cross_from = 3, .cross_to = 4, .stiffness = 1}},
                           0, twill::law()),
               std::invalid_argument);
  EXPECT_THROW(ClampSprings({{.node = 0, .next = 1, .direction = {1, 0, 0}, .axis = {0, 1, 0}, .stiffness = 1}}, 0,
                            twill::law()),
               std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

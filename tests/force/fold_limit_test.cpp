#include "sundrape/force/fold_limit.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sundrape/force/bend_springs.hpp"

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180, b = 0.01, stiffness = 4e-5;  // [rad], [m], [N m]

BendSprings spring(double relaxation_time = 0) {
  return BendSprings({{.previous = 0, .centre = 1, .next = 2, .cross_from = 3, .cross_to = 4, .stiffness = stiffness}},
                     relaxation_time);
}
/// A cross of threads whose second edge is turned by an angle about the crossing thread.
TestState turned(double angle) {
  TestState s{.q = Vector(15), .v = Vector::Zero(15)};
  s.q << -b, 0, 0, 0, 0, 0, b * std::cos(angle), 0, b * std::sin(angle), 0, -b, 0, 0, b, 0;
  return s;
}

TEST(FoldLimit, LeavesWhatIsNotFoldedAlone) {
  for (const double angle : {-150.0, -90.0, 0.0, 30.0, 149.9}) {
    const auto limit = fold_limit(angle * degree);
    EXPECT_EQ(limit.energy, 0);
    EXPECT_EQ(limit.turn, 0);
    EXPECT_EQ(limit.slope, 0);
  }
}

TEST(FoldLimit, IsTheDerivativeOfItsEnergyOnBothSides) {
  constexpr double step = 1e-6;
  for (const double sign : {-1.0, 1.0})
    for (const double angle : {151.0, 160.0, 170.0, 178.0}) {
      const double phi = sign * angle * degree;
      const auto limit = fold_limit(phi), before = fold_limit(phi - step), after = fold_limit(phi + step);
      EXPECT_NEAR((after.energy - before.energy) / (2 * step), limit.turn, 1e-6 * std::abs(limit.turn) + 1e-9);
      EXPECT_NEAR((after.turn - before.turn) / (2 * step), limit.slope, 1e-5 * limit.slope);
      EXPECT_GT(sign * limit.turn, 0);
    }
}

TEST(FoldLimit, HasNoBoundAtAHalfTurn) {
  // as 1/(1 − x): a tenth of the way that is left asks for ten times the energy
  const double width = pi - fold_limit_begin;
  const double near = fold_limit(pi - 1e-3 * width).energy, nearer = fold_limit(pi - 1e-4 * width).energy;
  EXPECT_NEAR(nearer / near, 10, 0.05);
  EXPECT_TRUE(std::isfinite(fold_limit(pi).energy));
}

TEST(FoldLimit, HasExactForcesAndTangentsInASpring) {
  for (const double angle : {-165.0, 155.0, 172.0})
    for (const double time : {0.0, 3e-4}) {
      auto state = turned(angle * degree);
      state.v = 0.1 * Vector::LinSpaced(15, -1, 1);
      expect_consistent(spring(time), state, 1e-5);
    }
}

TEST(FoldLimit, NoStepMayTurnASpringThroughAHalfTurn) {
  const auto bends = spring();
  const auto passes = [&](double from, double to) { return bends.passage(turned(from * degree), turned(to * degree)); };
  EXPECT_TRUE(bends.watches_passages());
  EXPECT_FALSE(passes(20, 170));
  EXPECT_FALSE(passes(-60, 60));
  for (const double sign : {-1.0, 1.0}) {
    const auto passage = passes(sign * 175, -sign * 175);
    ASSERT_TRUE(passage);
    EXPECT_EQ(passage->what, "the thread through itself at node 1");
    EXPECT_EQ(passage->place, Vector3(0, 0, 0));
  }
}

TEST(FoldLimit, WithinItCorrectionsHaveToBeSmallAgainstWhatIsLeft) {
  const auto bends = spring();
  const auto settles = [&](double before, double after) {
    return bends.settles(turned(before * degree), turned(after * degree));
  };
  EXPECT_TRUE(settles(20, 140));
  EXPECT_FALSE(settles(178, 170));
  EXPECT_FALSE(settles(150, 170));
  EXPECT_TRUE(settles(169.5, 170));
  EXPECT_TRUE(settles(-169.5, -170));
}

}  // namespace
}  // namespace sundrape

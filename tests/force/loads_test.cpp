#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/force/dead_load.hpp"
#include "sundrape/force/drag.hpp"
#include "sundrape/force/edge_moment.hpp"
#include "sundrape/force/pressure.hpp"

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

TEST(DeadLoad, ForceIsTheGradientOfTheEnergy) {
  const DeadLoad load("weight", EnergyKind::gravity, weight(Vector::Constant(3, 2e-5), {0, 0, -9.80665}));
  expect_consistent(load, random_state(3, 1));
  EXPECT_EQ(load.external_power(random_state(3, 1)), 0);
}

TEST(DeadLoad, OnARampWhatDoesNotYetActCountsAsPowerFromOutside) {
  // With energy −F·q booked in full, power (λ − 1) F·v makes up for the share that does not act yet.
  Vector forces = Vector::Zero(3);
  forces[2] = -2;
  const DeadLoad load("force", EnergyKind::load, forces, LoadCourse{.rise = 1.0});
  TestState s = random_state(1, 4);
  s.time = 0.25;
  const double share = LoadCourse{.rise = 1.0}.share(s);
  Vector f = Vector::Zero(3);
  load.add_force(s, f);
  EXPECT_NEAR(f[2], -2 * share, 1e-15);
  EXPECT_NEAR(load.external_power(s), (share - 1) * -2 * s.v[2], 1e-15);
}

TEST(DeadLoad, InStagesItsForceIsTheGradientOfItsEnergyAtEveryLoadFactor) {
  Vector forces = Vector::Zero(9);
  forces[2] = -2;
  const DeadLoad load("force", EnergyKind::load, forces, LoadCourse{.stages = {0.5, 1}});
  const TestState random = random_state(3, 4);
  for (const int stage : {1, 2}) {
    const State s{0.3, random.q, random.v, stage};
    Vector f = Vector::Zero(9);
    load.add_force(s, f);
    EXPECT_NEAR(f.dot(random.q), -load.energy(s), 1e-15);
    EXPECT_NEAR(f[2], -2 * (stage == 1 ? 0.15 : 0.65), 1e-15);  // 0.3 of the way to 0.5, and from there to 1
    EXPECT_EQ(load.external_power(s), 0);
  }
}

TEST(Drag, TangentIsExactAndTakesTheEnergyItReports) {
  const Drag drag(Vector::Constant(3, 2e-5), 1.5);
  expect_consistent(drag, random_state(3, 2));
  expect_dissipates_what_it_says(drag, random_state(3, 2));
}

TEST(EdgeMoment, TangentIsExact) {
  expect_consistent(EdgeMoment({{0, 1, {1e-4, -2e-4, 3e-4}}, {2, 1, {0, 1e-4, 0}}}), random_state(3, 3));
}

TEST(EdgeMoment, HasTheMomentAcrossTheEdgeAndNoResultant) {
  const EdgeMoment term({{0, 1, {0, 2e-4, 0}}});
  Vector q(6), v = Vector::Zero(6), f = Vector::Zero(6);
  q << 0, 0, 0, 0.006, 0, -0.008;
  term.add_force({0, q, v}, f);
  EXPECT_NEAR((f.head<3>() + f.tail<3>()).norm(), 0, 1e-18);
  const Vector3 arm = q.tail<3>() - q.head<3>(), force = f.tail<3>();
  EXPECT_NEAR((arm.cross(force) - Vector3(0, 2e-4, 0)).norm(), 0, 1e-18);
}

TEST(Pressure, TangentIsExact) { expect_consistent(Pressure({{0, 1, 2, 3}}, 40), random_state(4, 6)); }

TEST(Pressure, PushesAFlatFaceByPressureTimesArea) {
  Vector q(12), v = Vector::Zero(12), f = Vector::Zero(12);
  q << 0, 0, 0, 0.02, 0, 0, 0.02, 0.01, 0, 0, 0.01, 0;
  Pressure({{0, 1, 2, 3}}, 40).add_force({0, q, v}, f);
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 4; ++k) sum += point(f, k);
  EXPECT_NEAR(sum.z(), 40 * 2e-4, 1e-15);
  EXPECT_NEAR(sum.head<2>().norm(), 0, 1e-18);
}

}  // namespace
}  // namespace sundrape

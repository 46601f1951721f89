#include "sundrape/force/obstacle_contact.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/force/obstacle_box.hpp"
#include "sundrape/force/obstacle_cylinder.hpp"
#include "sundrape/force/obstacle_plane.hpp"
#include "sundrape/force/obstacle_sphere.hpp"
#include "sundrape/mesh/builders.hpp"

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

std::vector<ContactBody> smooth(const Obstacles& obstacles) {
  std::vector<ContactBody> bodies;
  for (const auto& obstacle : obstacles) bodies.push_back({obstacle});
  return bodies;
}

const Vector nothing;
const State start{0, nothing, nothing};

constexpr double stiffness = 4e6, smoothing = 2e-3;  // a wide smoothing, so that random points fall on all of the law

const Obstacles floor_at_zero = {std::make_shared<PlaneObstacle>(Vector3::Zero(), Vector3::UnitZ())};

std::vector<ContactPoint> nodes(const std::vector<double>& areas) { return contact_points(areas); }

TestState at(const std::vector<Vector3>& nodes) { return perturbed(nodes, 0, 0, 1); }

/// Nodes close to the surface of a body, from deep in the linear part of the law to just out of reach.
TestState scattered_over(const Obstacle& body, int count) {
  std::vector<Vector3> nodes;
  const auto bounds = body.bounds();
  for (int i = 0; static_cast<int>(nodes.size()) < count; ++i) {
    const auto turn = [i](double rate) { return std::sin(rate * (i + 1)); };
    const Vector3 x = bounds.center() + 0.55 * bounds.sizes().cwiseProduct(Vector3(turn(1.7), turn(2.9), turn(4.3)));
    const auto d = body.distance(x);
    if (d.gap < -1e-2) continue;
    const double wanted = smoothing * (-0.5 + 1.6 * static_cast<double>(nodes.size()) / count);
    nodes.emplace_back(x + (wanted - d.gap) * d.normal);
  }
  return at(nodes);
}

TEST(ObstacleContact, ForceIsTheGradientAndTangentTheHessianOnEveryCurvature) {
  const Obstacles bodies = {std::make_shared<SphereObstacle>(0.05),
                            std::make_shared<BoxObstacle>(Vector3(0.1, 0.08, 0.06), 0.012),
                            std::make_shared<CylinderObstacle>(0.04, 0.1, 0.012)};
  for (const auto& body : bodies) {
    const ObstacleContact contact({{body}}, contact_points(std::vector<double>(30, 1e-4)), {stiffness, smoothing});
    const auto state = scattered_over(*body, 30);
    EXPECT_GT(contact.report(state).contacts, 20);
    expect_consistent(contact, state, 1e-6);
  }
}

TEST(ObstacleContact, PointsBetweenNodesPushOnTheNodesAroundThem) {
  const auto mesh = rectangle(0.02, 0.02, 2, 2);
  const ObstacleContact contact(smooth(floor_at_zero), contact_points(mesh, 3), {stiffness, smoothing});
  auto state = perturbed(mesh.reference, 1e-3, 0, 2);
  EXPECT_GT(contact.report(state).contacts, 30);
  expect_consistent(contact, state, 1e-6);
  Vector f = Vector::Zero(state.q.size());
  contact.add_force(state, f);
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < mesh.nodes(); ++i) sum += f.segment<3>(3 * i);
  EXPECT_NEAR((sum - contact.total_forces(state)[0]).norm(), 0, 1e-12 * sum.norm());
}

TEST(ObstacleContact, TangentIsExactWhereTwoBodiesAreTouchedAtOnce) {
  const Obstacles corner = {std::make_shared<PlaneObstacle>(Vector3::Zero(), Vector3::UnitZ()),
                            std::make_shared<PlaneObstacle>(Vector3::Zero(), Vector3(1, 0, 0.5))};
  const ObstacleContact contact(smooth(corner), nodes({1e-4, 2e-4}), {stiffness, smoothing});
  const auto state = at({{1e-3, 0, 5e-4}, {-1e-3, 0.3, 1e-3}});
  EXPECT_EQ(contact.report(state).contacts, 4);
  expect_consistent(contact, state, 1e-6);
}

TEST(ObstacleContact, RestingNodeCarriesItsWeightAtTheDepthOfTheLaw) {
  // linear branch: A k (w/2 − gap) = W, so gap = w/2 − W / (A k)
  constexpr double area = 1e-4, weight = 0.6;
  const ObstacleContact contact(smooth(floor_at_zero), nodes({area}), {stiffness, smoothing});
  const double gap = 0.5 * smoothing - weight / (area * stiffness);
  ASSERT_LT(gap, 0);
  const auto state = at({{0.1, 0.2, gap}});
  Vector force = Vector::Zero(3);
  contact.add_force(state, force);
  EXPECT_NEAR(force[2], weight, 1e-12);
  EXPECT_EQ(force.head<2>().norm(), 0);
  const auto report = contact.report(state);
  EXPECT_EQ(report.contacts, 1);
  EXPECT_NEAR(report.deepest_penetration, -gap, 1e-15);
  EXPECT_NEAR(contact.total_forces(state).front().z(), weight, 1e-12);
}

TEST(ObstacleContact, EnergyIsTheWorkOfPressingANodeDown) {
  const ObstacleContact contact(smooth(floor_at_zero), nodes({1e-4}), {stiffness, smoothing});
  double work = 0;
  constexpr int steps = 4000;
  constexpr double from = 1.2 * smoothing, to = -0.8 * smoothing, step = (from - to) / steps;
  for (int i = 0; i < steps; ++i) {
    Vector force = Vector::Zero(3);
    contact.add_force(at({{0, 0, from - (i + 0.5) * step}}), force);
    work += force[2] * step;
  }
  EXPECT_NEAR(contact.energy(at({{0, 0, to}})), work, 1e-6 * work);
}

TEST(ObstacleContact, FarNodesFeelNothing) {
  const Obstacles table = {std::make_shared<BoxObstacle>(Vector3(0.08, 0.08, 0.08), 0.001)};
  const ObstacleContact contact(smooth(table), nodes({1e-4, 1e-4}), {stiffness, smoothing});
  const auto state = at({{0.2, 0, 0}, {0, 0, 0.04 + 1.001 * smoothing}});
  Vector force = Vector::Zero(6);
  contact.add_force(state, force);
  EXPECT_EQ(force.norm(), 0);
  EXPECT_EQ(contact.energy(state), 0);
  EXPECT_EQ(contact.report(state).contacts, 0);
  EXPECT_TRUE(dense_tangent(contact, state, 1, 0, Symmetry::symmetric).isZero());
}

TEST(ObstacleContact, TotalForcesAreKeptApartByObstacleAndSumToTheNodesForces) {
  const Obstacles bodies = {floor_at_zero.front(), std::make_shared<SphereObstacle>(0.05)};
  const ObstacleContact contact(smooth(bodies), nodes({1e-4, 1e-4}), {stiffness, smoothing});
  const auto state = at({{0.3, 0, 0.001}, {0, 0, 0.0495}});
  const auto forces = contact.total_forces(state);
  EXPECT_GT(forces[0].z(), 0);
  EXPECT_GT(forces[1].z(), 0);
  Vector force = Vector::Zero(6);
  contact.add_force(state, force);
  EXPECT_TRUE((forces[0] + forces[1]).isApprox(force.head<3>() + force.tail<3>(), 1e-14));
  EXPECT_TRUE(forces[0].isApprox(force.head<3>(), 1e-14));
}

TEST(ObstacleContact, ClosestIsTheNearestSurfaceWithItsNormal) {
  const Obstacles bodies = {floor_at_zero.front(), std::make_shared<SphereObstacle>(0.05)};
  const ObstacleContact contact(smooth(bodies), nodes({1e-4}), {stiffness, smoothing});
  const auto above_ball = contact.closest(start, {0, 0, 0.06});
  EXPECT_NEAR(above_ball.gap, 0.01, 1e-15);
  const auto over_floor = contact.closest(start, {0.3, 0, 0.02});
  EXPECT_NEAR(over_floor.gap, 0.02, 1e-15);
  EXPECT_TRUE(over_floor.normal.isApprox(Vector3::UnitZ()));
  EXPECT_TRUE(std::isinf(ObstacleContact({}, nodes({1e-4}), {stiffness, smoothing}).closest(start, {0, 0, 0}).gap));
}

/// A rough ball that is lifted while it turns, here half way.
ContactBody rough_ball(double friction) {
  return {std::make_shared<SphereObstacle>(0.05), friction,
          PathCourse{KeyframePath{Keyframes({0, 1}, Eigen::MatrixXd{{0, 0.01}, {0, 0.02}, {0, 0.05}, {0, 2}},
                                            Keyframes::Between::straight),
                                  {0, 0, 0.01},
                                  Vector3::UnitX()},
                     {.start = 0, .duration = 1, .profile = PathTiming::Profile::linear}}};
}

TestState over_moved_ball(double speed) {
  const SphereObstacle ball(0.05);
  auto state = scattered_over(ball, 30);
  const State half{0.5, nothing, nothing};
  const auto at = rough_ball(0).course->placement(half);
  for (int i = 0; i < 30; ++i) {
    const Vector3 x = point(state.q, i);
    point(state.q, i) = at(x);
    point(state.v, i) = speed * Vector3(std::sin(1.0 * i), std::cos(2.0 * i), std::sin(3.0 * i));
  }
  state.time = 0.5;
  return state;
}

TEST(ObstacleContact, TangentOfFrictionOnAMovingBodyIsItsDerivative) {
  constexpr double creep = 0.1;  // [m/s]: some points stick, some slide
  const ObstacleContact contact({rough_ball(0.4)}, contact_points(std::vector<double>(30, 1e-4)),
                                {stiffness, smoothing}, FrictionLaw(creep), FrictionMatrix::tangent);
  const auto state = over_moved_ball(0.2);
  const auto report = contact.report(state);
  EXPECT_GT(report.sliding, 5);
  EXPECT_LT(report.sliding, report.contacts - 3);
  expect_tangent_is_force_derivative(contact, state, 1e-5);
}

TEST(ObstacleContact, FrictionOpposesSlidingOnTheMovingSurface) {
  const ObstacleContact smooth_one({rough_ball(0)}, contact_points(std::vector<double>(30, 1e-4)),
                                   {stiffness, smoothing});
  const ObstacleContact rough({rough_ball(0.4)}, contact_points(std::vector<double>(30, 1e-4)), {stiffness, smoothing},
                              FrictionLaw(1e-4));
  const auto state = over_moved_ball(0.2);
  Vector push = Vector::Zero(90), all = push;
  smooth_one.add_force(state, push);
  rough.add_force(state, all);
  const auto rate = rough_ball(0).course->rate(state);
  double heat = 0, work = 0;
  for (int i = 0; i < 30; ++i) {
    const Vector3 friction = point(all, i) - point(push, i);
    const Vector3 relative = Vector3(point(state.v, i)) - rate(point(state.q, i));
    EXPECT_NEAR(friction.norm(), 0.4 * Vector3(point(push, i)).norm(), 1e-9);  // all of them slide
    EXPECT_NEAR(friction.dot(point(push, i)), 0, 1e-12);
    heat -= friction.dot(relative);
    work += Vector3(point(all, i)).dot(rate(point(state.q, i)));
  }
  EXPECT_GT(heat, 0);
  EXPECT_NEAR(rough.dissipated_power(state), heat, 1e-9 * heat);
  EXPECT_NEAR(rough.external_power(state), work, 1e-9 * std::abs(work));
}

TEST(ObstacleContact, RefusesNegativeAreasAndMissingBodies) {
  EXPECT_THROW(ObstacleContact(smooth(floor_at_zero), nodes({-1.0}), {stiffness, smoothing}), std::invalid_argument);
  EXPECT_THROW(ObstacleContact({ContactBody{}}, nodes({1.0}), {stiffness, smoothing}), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

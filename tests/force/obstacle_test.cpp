#include "sundrape/force/obstacle.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "sundrape/force/obstacle_box.hpp"
#include "sundrape/force/obstacle_capsule.hpp"
#include "sundrape/force/obstacle_cylinder.hpp"
#include "sundrape/force/obstacle_pedestal.hpp"
#include "sundrape/force/obstacle_plane.hpp"
#include "sundrape/force/obstacle_sphere.hpp"

#include "support/random_points.hpp"

namespace sundrape {
namespace {

/// A convex body together with its support function h(u) = max over its points of u·x, for unit vectors u.
///
/// The signed distance to any convex body is the maximum over all directions of u·x − h(u): an independent reference.
struct Specimen {
  std::string name;
  std::shared_ptr<const Obstacle> obstacle;
  std::function<double(const Vector3&)> support;
  double smooth_depth;  // down to here inside, the nearest surface point is unique [m]
};

double across(const Vector3& u) { return std::hypot(u.x(), u.y()); }

std::vector<Specimen> specimens() {
  const auto box = [](double r) {
    return [r](const Vector3& u) { return Vector3(0.05 - r, 0.04 - r, 0.03 - r).dot(u.cwiseAbs()) + r; };
  };
  const auto cylinder = [](double radius, double half, double r) {
    return [=](const Vector3& u) { return (radius - r) * across(u) + (half - r) * std::abs(u.z()) + r; };
  };
  const Vector3 tilt(0.3, -0.5, 0.8), shift(0.02, 0.01, -0.03);
  const Matrix3 turn = rotation_of_z_to(tilt);
  const auto placed = std::make_shared<PlacedObstacle>(std::make_unique<CylinderObstacle>(0.04, 0.12, 0.01),
                                                       RigidPlacement{turn, shift});
  const Vector3 size(0.1, 0.08, 0.06);
  return {
      {"box", std::make_shared<BoxObstacle>(size, 0.02), box(0.02), 0.015},
      {"sharp box", std::make_shared<BoxObstacle>(size, 0.0), box(0), 0},
      {"box rounded to the full", std::make_shared<BoxObstacle>(size, 0.03), box(0.03), 0.02},
      {"cylinder", std::make_shared<CylinderObstacle>(0.04, 0.12, 0.01), cylinder(0.04, 0.06, 0.01), 0.008},
      {"sharp cylinder", std::make_shared<CylinderObstacle>(0.04, 0.12, 0.0), cylinder(0.04, 0.06, 0), 0},
      {"round-topped cylinder", std::make_shared<CylinderObstacle>(0.04, 0.12, 0.04), cylinder(0.04, 0.06, 0.04), 0.03},
      {"sphere", std::make_shared<SphereObstacle>(0.05), [](const Vector3&) { return 0.05; }, 0.04},
      {"capsule", std::make_shared<CapsuleObstacle>(0.03, 0.1),
       [](const Vector3& u) { return 0.05 * std::abs(u.z()) + 0.03; }, 0.025},
      {"pedestal", std::make_shared<PedestalObstacle>(0.09, 0.04, 0.005),
       [=](const Vector3& u) { return cylinder(0.09, 0.02, 0.005)(u) - 0.02 * u.z(); }, 0.004},
      {"placed cylinder", placed,
       [=](const Vector3& u) { return cylinder(0.04, 0.06, 0.01)(turn.transpose() * u) + u.dot(shift); }, 0.008},
  };
}

/// Maximum of u·x − h(u): the best of many directions, refined by ever smaller random steps; good to 1e-6 m here.
double distance_by_search(const Specimen& specimen, const Vector3& x, samples::RandomPoints& points) {
  const auto value = [&](const Vector3& u) { return u.dot(x) - specimen.support(u); };
  Vector3 best = Vector3::UnitX();
  const auto try_direction = [&](const Vector3& u) {
    if (value(u) > value(best)) best = u;
  };
  for (int k = 0; k < 3; ++k) {
    try_direction(Vector3::Unit(k));
    try_direction(-Vector3::Unit(k));
  }
  for (int i = 0; i < 3000; ++i) try_direction(points.direction());
  for (int k = 0; k < 153; ++k)  // down to 1e-8
    for (int i = 0; i < 60; ++i) try_direction((best + 0.1 * std::pow(0.9, k) * points.direction()).normalized());
  return value(best);
}

TEST(Obstacles, DistanceIsExactOutsideAndInside) {
  samples::RandomPoints points(3);
  for (const auto& specimen : specimens())
    for (int i = 0; i < 60; ++i) {
      const Vector3 x = points.in_cube(0.12);
      EXPECT_NEAR(specimen.obstacle->distance(x).gap, distance_by_search(specimen, x, points), 1e-6) << specimen.name;
    }
}

TEST(Obstacles, NormalIsTheGradientAndCurvatureTheHessian) {
  constexpr double step = 1e-6;
  samples::RandomPoints points(5);
  for (const auto& specimen : specimens()) {
    int checked = 0;
    for (int i = 0; i < 400; ++i) {
      const Vector3 x = points.in_cube(0.12);
      const auto at = specimen.obstacle->distance(x);
      if (at.gap < -specimen.smooth_depth || std::abs(at.gap) < 1e-4) continue;
      ++checked;
      EXPECT_NEAR(at.normal.norm(), 1, 1e-14) << specimen.name;
      EXPECT_LT((at.curvature * at.normal).norm(), 1e-12 * (1 + at.curvature.norm())) << specimen.name;
      for (int k = 0; k < 3; ++k) {
        const auto ahead = specimen.obstacle->distance(x + step * Vector3::Unit(k));
        const auto behind = specimen.obstacle->distance(x - step * Vector3::Unit(k));
        EXPECT_NEAR((ahead.gap - behind.gap) / (2 * step), at.normal[k], 1e-7) << specimen.name;
        const Vector3 column = (ahead.normal - behind.normal) / (2 * step);
        EXPECT_LT((column - at.curvature.col(k)).norm(), 1e-6 * (1 + at.curvature.norm())) << specimen.name;
      }
    }
    EXPECT_GT(checked, 200) << specimen.name;
  }
}

TEST(Obstacles, BoundsHoldTheSurfaceTightly) {
  for (const auto& specimen : specimens()) {
    const auto bounds = specimen.obstacle->bounds();
    const bool turned = specimen.name == "placed cylinder";  // the box around a turned body's box is wider
    for (int k = 0; k < 3; ++k) {
      const double high = specimen.support(Vector3::Unit(k)), low = -specimen.support(-Vector3::Unit(k));
      EXPECT_GE(bounds.max()[k], high - 1e-15) << specimen.name;
      EXPECT_LE(bounds.min()[k], low + 1e-15) << specimen.name;
      EXPECT_LE(bounds.max()[k] - bounds.min()[k], (turned ? 1.6 : 1) * (high - low) + 1e-15) << specimen.name;
    }
  }
}

TEST(Obstacles, PlaneMeasuresAlongItsNormalWithoutEnd) {
  const PlaneObstacle plane({0, 0, 1}, {0, 3, 4});
  const auto d = plane.distance({7, 5, 1});
  EXPECT_NEAR(d.gap, 3, 1e-14);
  EXPECT_TRUE(d.normal.isApprox(Vector3(0, 0.6, 0.8)));
  EXPECT_TRUE(d.curvature.isZero());
  EXPECT_TRUE(plane.bounds().contains(Vector3(1e300, -1e300, 1e300)));

  const PlacedObstacle wall(std::make_unique<PlaneObstacle>(Vector3::Zero(), Vector3::UnitZ()),
                            {rotation_of_z_to({2, 0, 0}), {0.5, 0, 0}});
  EXPECT_NEAR(wall.distance({0.7, 9, 9}).gap, 0.2, 1e-14);
  EXPECT_TRUE(wall.bounds().contains(Vector3(1e300, -1e300, 1e300)));
}

TEST(Obstacles, TableTopIsFlatAndItsEdgeCurvesWithTheEdgeRadius) {
  const BoxObstacle table({0.08, 0.08, 0.08}, 0.002);
  EXPECT_TRUE(table.distance({0.01, 0.02, 0.041}).curvature.isZero());
  EXPECT_NEAR(table.distance({0.01, 0.02, 0.041}).gap, 0.001, 1e-15);
  // on the surface at 45° of the rounded edge, once around it
  const double c = 0.038 + 0.002 / std::numbers::sqrt2;
  const auto edge = table.distance({c, 0, c});
  EXPECT_NEAR(edge.gap, 0, 1e-15);
  EXPECT_TRUE(edge.normal.isApprox(Vector3(1, 0, 1).normalized(), 1e-12));
  EXPECT_NEAR(edge.curvature.trace(), 1 / 0.002, 1e-6);
}

TEST(Obstacles, PedestalTopLiesAtItsPlaceAndItsSideIsRound) {
  const PedestalObstacle pedestal(0.09, 0.1, 0.0);
  EXPECT_NEAR(pedestal.distance({0.03, 0.02, 0.004}).gap, 0.004, 1e-15);
  const auto side = pedestal.distance({0, 0.1, -0.05});
  EXPECT_NEAR(side.gap, 0.01, 1e-15);
  EXPECT_NEAR(side.curvature(0, 0), 1 / 0.1, 1e-12);
}

TEST(Obstacles, PointsOfSymmetryHaveFiniteDerivatives) {
  for (const auto& specimen : specimens())
    for (const Vector3& x : {Vector3(0, 0, 0), Vector3(0, 0, 0.07), Vector3(0, 0.06, 0), Vector3(0.05, 0.04, 0.03)}) {
      const auto d = specimen.obstacle->distance(x);
      EXPECT_NEAR(d.normal.norm(), 1, 1e-12) << specimen.name;
      EXPECT_TRUE(std::isfinite(d.gap) && d.curvature.allFinite()) << specimen.name;
    }
}

TEST(Obstacles, TopOfADomeCurvesBothWays) {
  // at 0.07 above the centre the surface is 0.01 below, a sphere of radius 0.04 about 0.03 below that
  const CylinderObstacle dome(0.04, 0.12, 0.04);
  const Matrix3 expected = Vector3(1 / 0.05, 1 / 0.05, 0).asDiagonal();
  EXPECT_TRUE(dome.distance({0, 0, 0.07}).curvature.isApprox(expected, 1e-12));
}

TEST(Obstacles, AxisRotationTakesZThereWhateverItsLength) {
  for (const Vector3& axis : {Vector3(0, 0, 2), Vector3(0, 0, -1), Vector3(1, 0, 0), Vector3(1, -2, 0.5)})
    EXPECT_TRUE((rotation_of_z_to(axis) * Vector3::UnitZ()).isApprox(axis.normalized(), 1e-12));
  EXPECT_THROW((void)rotation_of_z_to(Vector3::Zero()), std::invalid_argument);
}

TEST(Obstacles, ImpossibleSizesAreRefused) {
  EXPECT_THROW(BoxObstacle({0.1, 0, 0.1}, 0), std::invalid_argument);
  EXPECT_THROW(BoxObstacle({0.1, 0.1, 0.1}, 0.06), std::invalid_argument);
  EXPECT_THROW(BoxObstacle({0.1, 0.1, 0.1}, std::nan("")), std::invalid_argument);
  EXPECT_THROW(CylinderObstacle(0, 0.1, 0), std::invalid_argument);
  EXPECT_THROW(CylinderObstacle(0.1, 0.1, 0.06), std::invalid_argument);
  EXPECT_THROW(PedestalObstacle(0.1, -0.1, 0), std::invalid_argument);
  EXPECT_THROW(SphereObstacle(-1), std::invalid_argument);
  EXPECT_THROW(CapsuleObstacle(0.1, -1), std::invalid_argument);
  EXPECT_THROW(PlaneObstacle({0, 0, 0}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(PlacedObstacle(nullptr, {}), std::invalid_argument);
  EXPECT_THROW(PlacedObstacle(std::make_unique<SphereObstacle>(1), {-Matrix3::Identity(), Vector3::Zero()}),
               std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

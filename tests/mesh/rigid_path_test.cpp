#include "sundrape/mesh/rigid_path.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

const ArcPath arc{.centre = {1, 0, 0}, .axis = -Vector3::UnitY(), .angle = std::numbers::pi};

KeyframePath keyframes() {
  Eigen::MatrixXd values(4, 3);
  values << 0, 0.1, 0.3, 0, 0.2, 0, 0, -0.1, 0.1, 0, 1, 2.5;
  return {Keyframes({0, 0.5, 2}, values, Keyframes::Between::smooth), {0.1, 0.2, 0.3}, Vector3(1, 2, 2) / 3};
}

TEST(RigidPath, AnArcTurnsByItsShareOfTheAngleAndKeepsTheDistance) {
  EXPECT_NEAR((placement_along(arc, 0)({3, 5, 0}) - Vector3(3, 5, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((placement_along(arc, 0.5)({3, 5, 0}) - Vector3(1, 5, 2)).norm(), 0, 1e-15);
  EXPECT_NEAR((placement_along(arc, 1)({3, 5, 0}) - Vector3(-1, 5, 0)).norm(), 0, 1e-15);
}

TEST(RigidPath, ALineGoesOnBeyondItsEnd) {
  EXPECT_EQ(placement_along(LinePath{{1, 2, 3}}, 1.5)({1, 1, 1}), Vector3(2.5, 4, 5.5));
}

TEST(RigidPath, KeyframesTurnAboutTheirAxisThenTranslate) {
  const auto path = keyframes();
  EXPECT_NEAR((placement_along(path, 1)(path.centre) - path.centre - Vector3(0.3, 0, 0.1)).norm(), 0, 1e-14);
  EXPECT_NEAR(placement_along(path, 0.25).rotation.trace(), 1 + 2 * std::cos(1), 1e-14);
}

TEST(RigidPath, RatesAreTheDerivativesOfPlaces) {
  const Vector3 x(0.3, -0.7, 0.2);
  const double h = 1e-6;
  for (const auto& path : {RigidPath(arc), RigidPath(LinePath{{1, 2, 3}}), RigidPath(keyframes())})
    for (const double share : {0.1, 0.45, 0.9}) {
      const Vector3 expected = (placement_along(path, share + h)(x) - placement_along(path, share - h)(x)) / (2 * h);
      EXPECT_LT((rate_along(path, share)(placement_along(path, share)(x)) - expected).norm(), 1e-8);
    }
}

TEST(RigidPlacement, OneAfterTheOther) {
  const auto first = placement_along(arc, 0.3), second = placement_along(keyframes(), 0.6);
  const Vector3 x(0.3, -0.7, 0.2);
  EXPECT_LT(((second * first)(x)-second(first(x))).norm(), 1e-15);
  EXPECT_LT((second.inverse(second(x)) - x).norm(), 1e-15);
  // a rate seen from a frame is that of the point in it
  const RigidRate rate{{1, 2, 3}, {0.1, -0.2, 0.3}};
  EXPECT_LT((seen_from(second, rate)(second(x)) - second.rotation * rate(x)).norm(), 1e-14);
}

}  // namespace
}  // namespace sundrape

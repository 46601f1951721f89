#include "sundrape/mesh/rigid_path.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

TEST(RigidPath, AnArcTurnsByItsShareOfTheAngleAndKeepsTheDistance) {
  const ArcPath arc{.centre = {1, 0, 0}, .axis = -Vector3::UnitY(), .angle = std::numbers::pi};
  EXPECT_NEAR((carried_along(arc, 0, {3, 5, 0}) - Vector3(3, 5, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((carried_along(arc, 0.5, {3, 5, 0}) - Vector3(1, 5, 2)).norm(), 0, 1e-15);
  EXPECT_NEAR((carried_along(arc, 1, {3, 5, 0}) - Vector3(-1, 5, 0)).norm(), 0, 1e-15);
}

TEST(RigidPath, ALineGoesOnBeyondItsEnd) {
  EXPECT_EQ(carried_along(LinePath{{1, 2, 3}}, 1.5, {1, 1, 1}), Vector3(2.5, 4, 5.5));
}

}  // namespace
}  // namespace sundrape

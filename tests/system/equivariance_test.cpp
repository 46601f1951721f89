#include "sundrape/system/equivariance.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/force/dead_load.hpp"

namespace sundrape {
namespace {

/// Swaps points 0 and 1 by a half turn about the vertical through (1, 0, 0); point 2, a direction, stays its own.
PointMap half_turn() {
  return {.rotation = Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitZ()).matrix(),
          .centre = {1, 0, 0},
          .image = {1, 0, 2},
          .places = 2,
          .side = -1};
}

TEST(PointMap, MovesPlacesAndTurnsDirections) {
  Vector q(9);
  q << 0.5, 0.25, 3, 2, 0, 1, 0, 1, 2;
  Vector expected(9);
  expected << 0, 0, 1, 1.5, -0.25, 3, 0, 1, -2;  // by hand: (2 − x, −y, z), and −(−x, −y, z)
  EXPECT_LT((half_turn().move(q) - expected).norm(), 1e-15);
}

TEST(Equivariance, HoldsForALoadThatTheMapKeepsAndOnlyForThat) {
  const auto defect = [](const Vector3& on_0, const Vector3& on_1) {
    std::vector<std::unique_ptr<ForceTerm>> terms;
    Vector forces = Vector::Zero(9);
    forces.head<3>() = on_0;
    forces.segment<3>(3) = on_1;
    terms.push_back(std::make_unique<DeadLoad>("load", EnergyKind::load, forces, LoadCourse{}));
    const System system(Vector::Ones(3), std::move(terms), Unknowns(std::vector<Unknowns::Held>(3, Unknowns::Held{})),
                        Vector::Zero(9));
    return equivariance_defect(system, half_turn(), Vector::LinSpaced(9, 0, 1));
  };
  EXPECT_LT(defect({1, 2, 3}, {-1, -2, 3}), 1e-15);
  EXPECT_NEAR(defect({1, 0, 0}, {1, 0, 0}), 2, 1e-12);  // turned to the opposite
  EXPECT_NEAR(defect({0, 0, 3}, {0, 0, 4}), std::sqrt(2.0) / 5, 1e-12);
}

TEST(Equivariance, OfSupportsNeedsTheSameComponentsHeldAtTheSameValues) {
  Vector held(9);
  held << 0.5, 0, 3, 1.5, 0, 3, 0, 0, 1;
  const auto same = [&](const Unknowns::Held& of_0, const Unknowns::Held& of_1, const PointMap& map) {
    return maps_supports(Unknowns({of_0, of_1, Unknowns::Held{}}), map, held, 1e-9);
  };
  const Unknowns::Held x{true, false, false}, y{false, true, false}, all{true, true, true};
  EXPECT_TRUE(same(x, x, half_turn()));
  EXPECT_TRUE(same(all, all, half_turn()));
  EXPECT_FALSE(same(x, y, half_turn()));
  EXPECT_FALSE(same(x, {}, half_turn()));
  auto elsewhere = half_turn();
  elsewhere.centre.x() += 1e-6;
  EXPECT_FALSE(same(x, x, elsewhere));
  EXPECT_TRUE(same(y, y, elsewhere));  // x is free there
}

}  // namespace
}  // namespace sundrape

#include "sundrape/mesh/builders.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sundrape {
namespace {

using std::numbers::pi;

double area(const QuadMesh& mesh) {
  const auto areas = quad_areas(mesh);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

struct CellQuality {
  double smallest_angle = 180, largest_angle = 0;  // [deg]
  double aspect_ratio = 1;                         // longest over shortest side of one cell
};

CellQuality quality(const QuadMesh& mesh) {
  CellQuality worst;
  for (const auto& quad : mesh.quads) {
    double shortest = 1e300, longest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto corner = [&](std::size_t c) { return mesh.reference[static_cast<std::size_t>(quad[c % 4])]; };
      const Vector3 ahead = corner(k + 1) - corner(k), back = corner(k + 3) - corner(k);
      const double angle = std::atan2(ahead.cross(back).z(), ahead.dot(back)) * 180 / pi;
      worst.smallest_angle = std::min(worst.smallest_angle, angle);
      worst.largest_angle = std::max(worst.largest_angle, angle);
      shortest = std::min(shortest, ahead.norm());
      longest = std::max(longest, ahead.norm());
    }
    worst.aspect_ratio = std::max(worst.aspect_ratio, longest / shortest);
  }
  return worst;
}

TEST(Rectangle, NumbersItsNodesAlongTheWarpFirst) {
  const auto mesh = rectangle(0.3, 0.2, 3, 2);
  ASSERT_EQ(mesh.nodes(), 12);
  ASSERT_EQ(mesh.quads.size(), 6U);
  EXPECT_TRUE(mesh.reference[0].isApprox(Vector3(-0.15, -0.1, 0)));
  EXPECT_TRUE(mesh.reference[1].isApprox(Vector3(-0.05, -0.1, 0)));
  EXPECT_TRUE(mesh.reference[4 + 3].isApprox(Vector3(0.15, 0, 0)));
  EXPECT_EQ(mesh.quads[4], (std::array<int, 4>{5, 6, 10, 9}));
}

TEST(Rectangle, NamesItsEdgesAndCorners) {
  const auto sets = rectangle(0.3, 0.2, 3, 2).sets;
  using Nodes = std::vector<int>;
  EXPECT_EQ(sets.at("left"), (Nodes{0, 4, 8}));
  EXPECT_EQ(sets.at("right"), (Nodes{3, 7, 11}));
  EXPECT_EQ(sets.at("bottom"), (Nodes{0, 1, 2, 3}));
  EXPECT_EQ(sets.at("top"), (Nodes{8, 9, 10, 11}));
  EXPECT_EQ(sets.at("bottom_left"), Nodes{0});
  EXPECT_EQ(sets.at("bottom_right"), Nodes{3});
  EXPECT_EQ(sets.at("top_left"), Nodes{8});
  EXPECT_EQ(sets.at("top_right"), Nodes{11});
  EXPECT_EQ(sets.at("boundary"), (Nodes{0, 1, 2, 3, 4, 7, 8, 9, 10, 11}));
  EXPECT_EQ(sets.at("all").size(), 12U);
}

TEST(Rectangle, HasItsAreaAndMayBeOneCellWide) {
  EXPECT_NEAR(area(rectangle(0.2, 0.01, 20, 1)), 0.002, 1e-15);
  EXPECT_EQ(rectangle(0.2, 0.01, 20, 1).sets.at("boundary").size(), 42U);
}

TEST(Rectangle, MirrorsItselfToTheLastBit) {
  const auto mesh = rectangle(0.2, 0.2, 7, 7);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(mesh.reference[i], -mesh.reference[63 - i]);
}

TEST(Disc, CellsAreFarFromDegenerateAtEverySize) {
  for (int cells = 4; cells <= 80; ++cells) {
    const auto worst = quality(disc(0.15, cells));
    EXPECT_GT(worst.smallest_angle, 58) << cells;
    EXPECT_LT(worst.largest_angle, 128) << cells;
    EXPECT_LT(worst.aspect_ratio, 2) << cells;
  }
}

TEST(Disc, BoundaryLiesOnTheCircleAndTheCentreAtTheOrigin) {
  for (const int cells : {3, 8, 13, 30}) {
    const auto mesh = disc(0.15, cells);
    require_sound(mesh);
    for (const int i : mesh.sets.at("boundary"))
      EXPECT_NEAR(mesh.reference[static_cast<std::size_t>(i)].norm(), 0.15, 1e-15);
    Vector3 centre = Vector3::Zero();
    for (const int i : mesh.sets.at("centre")) centre += mesh.reference[static_cast<std::size_t>(i)];
    EXPECT_NEAR(centre.norm(), 0, 1e-15);
    EXPECT_EQ(mesh.sets.at("centre").size(), cells % 2 == 0 ? 1U : 4U);
  }
}

TEST(Disc, AreaConvergesToThatOfTheCircleAtSecondOrder) {
  const double exact = pi * 0.15 * 0.15;
  const double coarse = exact - area(disc(0.15, 12)), fine = exact - area(disc(0.15, 24));
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05);
  EXPECT_LT(fine, 2e-3 * exact);
}

TEST(Annulus, NumbersItsNodesRoundTheInnerCircleFirst) {
  const auto mesh = annulus(0.1, 0.2, 2, 8);
  ASSERT_EQ(mesh.nodes(), 24);
  ASSERT_EQ(mesh.quads.size(), 16U);
  EXPECT_TRUE(mesh.reference[2].isApprox(Vector3(0, 0.1, 0)));
  EXPECT_TRUE(mesh.reference[8].isApprox(Vector3(0.15, 0, 0)));
  EXPECT_EQ(mesh.sets.at("inner").back(), 7);
  EXPECT_EQ(mesh.sets.at("outer").front(), 16);
  EXPECT_EQ(mesh.sets.at("boundary").size(), 16U);
}

TEST(Annulus, AreaConvergesAtSecondOrder) {
  const double exact = pi * (0.04 - 0.01);
  const double coarse = exact - area(annulus(0.1, 0.2, 3, 24)), fine = exact - area(annulus(0.1, 0.2, 6, 48));
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.02);
}

TEST(Builders, NormalsPointUp) {
  for (const auto& mesh : {rectangle(0.2, 0.1, 4, 2), disc(0.1, 9), annulus(0.1, 0.2, 2, 12)})
    for (const auto& normal : node_normals(mesh, mesh.reference)) EXPECT_NEAR(normal.z(), 1, 1e-14);
}

TEST(Builders, RefuseEmptyShapes) {
  EXPECT_THROW((void)rectangle(0, 1, 2, 2), std::invalid_argument);
  EXPECT_THROW((void)rectangle(1, std::nan(""), 2, 2), std::invalid_argument);
  EXPECT_THROW((void)rectangle(1, 1, 0, 2), std::invalid_argument);
  EXPECT_THROW((void)disc(-1, 8), std::invalid_argument);
  EXPECT_THROW((void)disc(1, 2), std::invalid_argument);
  EXPECT_THROW((void)annulus(0.2, 0.1, 2, 8), std::invalid_argument);
  EXPECT_THROW((void)annulus(0.1, 0.2, 2, 2), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

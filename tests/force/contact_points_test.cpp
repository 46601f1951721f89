#include "sundrape/force/contact_points.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

double total_area(const std::vector<ContactPoint>& points) {
  return std::accumulate(points.begin(), points.end(), 0.0,
                         [](double sum, const ContactPoint& p) { return sum + p.area; });
}

TEST(ContactPoints, CutEverySideAndShareTheWholeArea) {
  const auto mesh = rectangle(0.3, 0.2, 3, 2);
  for (const int parts : {1, 2, 3, 5}) {
    const auto points = contact_points(mesh, parts);
    EXPECT_EQ(std::ssize(points), (3 * parts + 1) * (2 * parts + 1));
    EXPECT_NEAR(total_area(points), 0.06, 1e-15);
  }
}

TEST(ContactPoints, StandForEqualAreasInsideAndHalvesOnTheHem) {
  const auto points = contact_points(rectangle(0.2, 0.2, 2, 2), 2);
  Vector q(27);
  const auto mesh = rectangle(0.2, 0.2, 2, 2);
  for (int i = 0; i < mesh.nodes(); ++i) q.segment<3>(3 * i) = mesh.reference[static_cast<std::size_t>(i)];
  const Vector3 low = mesh.reference.front();
  for (const auto& p : points) {
    const Vector3 x = p.position(q) - low;
    const auto at_hem = [](double s) { return s < 1e-9 || s > 0.2 - 1e-9; };
    const double share = (at_hem(x.x()) ? 0.5 : 1) * (at_hem(x.y()) ? 0.5 : 1);
    EXPECT_NEAR(p.area, share * 0.05 * 0.05, 1e-15);
    EXPECT_NEAR(std::remainder(x.x(), 0.05), 0, 1e-12);
    EXPECT_NEAR(std::remainder(x.y(), 0.05), 0, 1e-12);
  }
}

TEST(ContactPoints, WeightsSumToOneAndNodesComeFirst) {
  const auto mesh = disc(0.1, 8);
  const auto points = contact_points(mesh, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(std::accumulate(points[i].weights.begin(), points[i].weights.end(), 0.0), 1, 1e-15);
    if (i < static_cast<std::size_t>(mesh.nodes())) {
      EXPECT_EQ(points[i].nodes[0], static_cast<int>(i));
    }
  }
}

TEST(ContactPoints, OfOnePartAreTheNodes) {
  const auto mesh = rectangle(0.2, 0.1, 4, 2);
  const auto points = contact_points(mesh, 1);
  const auto areas = tributary_areas(mesh);
  ASSERT_EQ(points.size(), areas.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_DOUBLE_EQ(points[i].area, areas[i]);
  EXPECT_THROW(static_cast<void>(contact_points(mesh, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

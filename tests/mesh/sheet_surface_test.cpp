#include "sundrape/mesh/sheet_surface.hpp"

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

TEST(SheetSurface, HasEveryEdgeOnceAndAllItsArea) {
  const auto mesh = rectangle(0.03, 0.02, 3, 2);
  const SheetSurface surface(mesh);
  EXPECT_EQ(surface.triangles.size(), 12U);
  EXPECT_EQ(surface.edges.size(), 3U * 3 + 2 * 4 + 6);
  double nodes = 0, edges = 0;
  for (const double a : surface.node_areas) nodes += a;
  for (const auto& e : surface.edges) edges += e.area;
  EXPECT_NEAR(nodes, 6e-4, 1e-15);
  EXPECT_NEAR(edges, 6e-4, 1e-15);
}

TEST(SheetSurface, NodesWithinAreThoseNearAlongTheSheet) {
  const auto mesh = rectangle(0.02, 0.02, 4, 4);  // 5 mm
  for (const auto& near : nodes_within(mesh, 4e-3)) EXPECT_TRUE(near.empty());
  const auto near = nodes_within(mesh, 6e-3);
  EXPECT_EQ(near[12], (std::vector<int>{7, 11, 13, 17}));
  EXPECT_EQ(nodes_within(mesh, 8e-3)[12].size(), 8U);
}

}  // namespace
}  // namespace sundrape

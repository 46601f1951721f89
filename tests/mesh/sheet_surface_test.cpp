#include "sundrape/mesh/sheet_surface.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
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

TEST(SheetSurface, EdgesAreInOrderAndKnowTheTrianglesThatHaveThem) {
  for (const auto& mesh : {rectangle(0.03, 0.02, 3, 2), disc(0.1, 8)}) {
    const SheetSurface surface(mesh);
    const auto ends = [](const SheetSurface::Edge& e) { return std::pair(e.i, e.j); };
    EXPECT_EQ(std::ranges::adjacent_find(surface.edges, std::ranges::greater_equal(), ends), surface.edges.end());
    for (const auto& edge : surface.edges) {
      std::vector<int> at;
      double area = 0;
      for (int t = 0; const auto& triangle : surface.triangles) {
        if (std::ranges::count(triangle, edge.i) == 1 && std::ranges::count(triangle, edge.j) == 1) {
          const auto x = [&](std::size_t k) { return mesh.reference[static_cast<std::size_t>(triangle[k])]; };
          area += (x(1) - x(0)).cross(x(2) - x(0)).norm() / 6;
          at.push_back(t);
        }
        ++t;
      }
      if (at.size() == 1) at.push_back(-1);
      EXPECT_EQ(at, std::vector<int>(edge.triangles.begin(), edge.triangles.end())) << edge.i << ", " << edge.j;
      EXPECT_NEAR(edge.area, area, 1e-15);
      const Vector3 way =
          mesh.reference[static_cast<std::size_t>(edge.j)] - mesh.reference[static_cast<std::size_t>(edge.i)];
      EXPECT_NEAR(edge.length, way.norm(), 1e-15);
    }
  }
}

TEST(SheetSurface, RefusesEdgesOfMoreThanTwoTriangles) {
  auto mesh = rectangle(0.01, 0.01, 1, 1);
  const auto [a, b, c, d] = mesh.quads.front();
  for (const double z : {0.01, -0.01}) mesh.reference.emplace_back(0, 0, z);
  for (const auto& other : {std::array{a, c, 4, 5}, std::array{a, 4, c, 5}}) {  // the diagonal as a side, as a diagonal
    auto both = mesh;
    both.quads.push_back(other);
    EXPECT_THROW(SheetSurface{both}, std::invalid_argument);
  }
  mesh.quads.insert(mesh.quads.end(), {{a, b, 4, 5}, {b, a, 5, 4}});
  EXPECT_THROW(SheetSurface{mesh}, std::invalid_argument);
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

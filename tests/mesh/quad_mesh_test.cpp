#include "sundrape/mesh/quad_mesh.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"
#include "sundrape/mesh/edges.hpp"

namespace sundrape {
namespace {

template <class Change>
QuadMesh changed(Change&& change) {
  auto mesh = rectangle(0.2, 0.1, 2, 1);
  change(mesh);
  return mesh;
}

TEST(QuadMesh, TributaryAreasSumToTheSheetAndHalveOnItsBoundary) {
  const auto areas = tributary_areas(rectangle(0.3, 0.3, 3, 3));
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 0.09, 1e-15);
  EXPECT_NEAR(areas[5], 0.01, 1e-15);
  EXPECT_NEAR(areas[1], 0.005, 1e-15);
  EXPECT_NEAR(areas[0], 0.0025, 1e-15);
}

TEST(QuadMesh, AreaOfATrapezoidIsExact) {
  QuadMesh mesh;
  mesh.reference = {{0, 0, 0}, {3, 0, 0}, {2, 2, 0}, {1, 2, 0}};
  mesh.material.resize(4, Eigen::Vector2d::Zero());
  mesh.quads = {{0, 1, 2, 3}};
  EXPECT_DOUBLE_EQ(quad_areas(mesh).front(), 4);  // ½ (3 + 1) 2
}

TEST(QuadMesh, TributaryLengthsSumToTheChosenEdge) {
  const auto mesh = rectangle(0.4, 0.2, 4, 2);
  const auto right = tributary_edge_lengths(mesh, mesh.sets.at("right"));
  EXPECT_NEAR(std::accumulate(right.begin(), right.end(), 0.0), 0.2, 1e-15);
  EXPECT_NEAR(right[4], 0.05, 1e-15);
  EXPECT_NEAR(right[9], 0.1, 1e-15);
  const auto all = tributary_edge_lengths(mesh, mesh.sets.at("all"));
  EXPECT_NEAR(std::accumulate(all.begin(), all.end(), 0.0), 1.2, 1e-15);  // the perimeter: inner edges do not count
}

TEST(QuadMesh, KnowsItsDiagonalAndMeanEdge) {
  const auto mesh = rectangle(0.3, 0.4, 3, 2);
  EXPECT_NEAR(diagonal(mesh), 0.5, 1e-15);
  EXPECT_NEAR(mean_edge_length(mesh), (9 * 0.1 + 8 * 0.2) / 17, 1e-15);  // 3 rows of 3 edges, 4 columns of 2
}

TEST(QuadMesh, EveryEdgeIsListedOnceWithItsQuads) {
  const auto table = edge_table(rectangle(0.2, 0.1, 2, 1));
  EXPECT_EQ(table.edges.size(), 7U);
  const auto& shared = table.edges[static_cast<std::size_t>(table.quad_edge[0][1])];
  EXPECT_EQ(shared.i, 1);
  EXPECT_EQ(shared.j, 4);
  EXPECT_EQ(shared.quads, (std::array<int, 2>{0, 1}));
}

TEST(QuadMesh, NormalsFollowTheDeformedSheet) {
  const auto mesh = rectangle(0.2, 0.2, 2, 2);
  auto tilted = mesh.reference;
  for (auto& x : tilted) x.z() = 0.75 * x.x();
  for (const auto& normal : node_normals(mesh, tilted)) EXPECT_TRUE(normal.isApprox(Vector3(-0.6, 0, 0.8), 1e-12));
}

TEST(QuadMesh, UnsoundMeshesAreRefused) {
  EXPECT_NO_THROW(require_sound(changed([](QuadMesh&) {})));
  const auto refused = [](auto&& change) { EXPECT_THROW(require_sound(changed(change)), std::invalid_argument); };
  refused([](QuadMesh& m) { m.quads[0][2] = 6; });                                      // missing node
  refused([](QuadMesh& m) { m.quads[0][2] = -1; });                                     // missing node
  refused([](QuadMesh& m) { m.quads[0][2] = 0; });                                      // repeated node
  refused([](QuadMesh& m) { m.reference[0] = m.reference[1] = Vector3(0, 0.05, 0); });  // no area
  refused([](QuadMesh& m) { m.quads.pop_back(); });                                     // unused nodes
  refused([](QuadMesh& m) { m.quads[1] = {1, 4, 5, 2}; });                              // runs round the other way
  refused([](QuadMesh& m) { m.quads.push_back(m.quads[0]); });                          // twice the same
  refused([](QuadMesh& m) { m.material.pop_back(); });                                  // no material coordinate
  refused([](QuadMesh& m) { m.reference[3].z() = std::numeric_limits<double>::infinity(); });
  refused([](QuadMesh& m) { m.material[3].x() = std::nan(""); });
}

TEST(QuadMesh, ThreeQuadsOnOneEdgeAreRefused) {
  const auto book = changed([](QuadMesh& m) {
    m.reference.emplace_back(0, -0.05, 0.1);
    m.reference.emplace_back(0, 0.05, 0.1);
    m.material.resize(8, Eigen::Vector2d::Zero());
    m.quads.push_back({1, 6, 7, 4});
  });
  EXPECT_THROW(require_sound(book), std::invalid_argument);
  EXPECT_THROW((void)boundary_nodes(book), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/mesh/threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"
#include "sundrape/mesh/joined.hpp"

namespace sundrape {
namespace {

double area(const QuadMesh& mesh) {
  const auto areas = quad_areas(mesh);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

/// Σ length · width over the warp or the weft segments.
double covered(const Threads& threads, bool warp) {
  double sum = 0;
  for (const auto& s : threads.segments)
    if (s.warp == warp) sum += s.length * s.width;
  return sum;
}

/// A rectangle whose inner nodes are shifted, so that no cell is square.
QuadMesh skewed_sheet() {
  auto mesh = rectangle(0.4, 0.3, 4, 3);
  for (std::size_t i = 0; i < mesh.reference.size(); ++i) {
    const auto k = static_cast<double>(i);
    mesh.reference[i] += Vector3(0.012 * std::sin(3 * k), 0.011 * std::cos(5 * k), 0.02 * std::sin(k));
    mesh.material[i] = mesh.reference[i].head<2>();
  }
  return mesh;
}

const Bend* bend_at(const Threads& threads, int centre, bool warp) {
  const auto found =
      std::ranges::find_if(threads.bends, [&](const Bend& b) { return b.centre == centre && b.warp == warp; });
  return found == threads.bends.end() ? nullptr : &*found;
}

TEST(Threads, GridThreadsStandForOneSpacingInsideAndHalfOfItOnTheBoundary) {
  const auto mesh = rectangle(0.4, 0.6, 4, 3);  // cells 0.1 by 0.2
  const auto threads = find_threads(mesh);
  ASSERT_EQ(threads.segments.size(), 4U * 4 + 5 * 3);
  for (const auto& s : threads.segments) {
    const Vector3& a = mesh.reference[static_cast<std::size_t>(s.i)];
    const Vector3& b = mesh.reference[static_cast<std::size_t>(s.j)];
    EXPECT_EQ(s.warp, a.y() == b.y());
    EXPECT_NEAR(s.length, s.warp ? 0.1 : 0.2, 1e-15);
    const bool on_boundary = s.warp ? std::abs(a.y()) > 0.29 : std::abs(a.x()) > 0.19;
    EXPECT_NEAR(s.width, (s.warp ? 0.2 : 0.1) * (on_boundary ? 0.5 : 1), 1e-15);
  }
}

TEST(Threads, WarpCoversTheSheetOnceAndWeftOnceMore) {
  for (const auto& mesh : {rectangle(0.2, 0.1, 7, 5), rectangle(0.2, 0.01, 20, 1), rectangle(0.01, 0.2, 1, 20)}) {
    EXPECT_NEAR(covered(find_threads(mesh), true), area(mesh), 1e-15);
    EXPECT_NEAR(covered(find_threads(mesh), false), area(mesh), 1e-15);
  }
}

TEST(Threads, BothDirectionsTogetherCoverAnySheetTwice) {
  for (const auto& mesh : {skewed_sheet(), disc(0.15, 13), annulus(0.1, 0.2, 3, 17)}) {
    const auto threads = find_threads(mesh);
    EXPECT_NEAR(covered(threads, true) + covered(threads, false), 2 * area(mesh), 1e-14);
  }
}

TEST(Threads, WarpCoverageOfRoundSheetsConvergesAtSecondOrder) {
  const auto disc_error = [](int cells) {
    return std::abs(covered(find_threads(disc(1, cells)), true) - std::numbers::pi);
  };
  const auto annulus_error = [](int cells) {
    return std::abs(covered(find_threads(annulus(1, 2, cells, 8 * cells)), true) - 3 * std::numbers::pi);
  };
  for (const int cells : {8, 16, 32}) {
    EXPECT_LT(disc_error(cells), 12.0 / (cells * cells)) << cells;
    EXPECT_LT(annulus_error(cells), 4.0 / (cells * cells)) << cells;
  }
}

TEST(Threads, ASheetCutOnTheBiasHasTwoFamiliesOfThreads) {
  auto mesh = rectangle(0.4, 0.4, 4, 4);
  const Eigen::Rotation2Dd turn(std::numbers::pi / 4);
  for (auto& uv : mesh.material) uv = turn * uv;
  const auto threads = find_threads(mesh);
  for (const auto& s : threads.segments)
    EXPECT_EQ(s.warp, s.j == s.i + 1);  // along x, which lies at (1, 1) of the cloth
}

TEST(Threads, NodesInsideHaveTwoBendsBoundaryNodesOneAndCornersNone) {
  const auto mesh = rectangle(0.4, 0.3, 4, 3);
  const auto threads = find_threads(mesh);
  std::vector<int> bends(20, 0), expected(20, 2);
  for (const auto& b : threads.bends) ++bends[static_cast<std::size_t>(b.centre)];
  for (const int i : mesh.sets.at("boundary")) expected[static_cast<std::size_t>(i)] = 1;
  for (const char* corner : {"bottom_left", "bottom_right", "top_left", "top_right"})
    expected[static_cast<std::size_t>(mesh.sets.at(corner).front())] = 0;
  EXPECT_EQ(bends, expected);
}

TEST(Threads, AStripOneCellWideBendsAlongItsTwoEdges) {
  const auto threads = find_threads(rectangle(0.4, 0.1, 4, 1));
  ASSERT_EQ(threads.bends.size(), 6U);  // three inner nodes on each edge
  double covered_by_bends = 0;
  for (const auto& b : threads.bends) {
    EXPECT_TRUE(b.warp);
    EXPECT_EQ(std::abs(b.next - b.previous), 2);
    EXPECT_NEAR(b.length, 0.1, 1e-15);
    EXPECT_NEAR(b.width, 0.05, 1e-15);
    covered_by_bends += b.length * b.width;
  }
  EXPECT_NEAR(covered_by_bends, 0.3 * 0.1, 1e-15);  // all but half a cell at either free end
}

TEST(Threads, BendOfAGridPassesStraightThroughItsNode) {
  const auto threads = find_threads(rectangle(0.4, 0.3, 4, 3));
  const auto* warp = bend_at(threads, 6, true);  // ix = 1, iy = 1
  ASSERT_TRUE(warp);
  EXPECT_EQ(std::minmax(warp->previous, warp->next), std::minmax(5, 7));
  EXPECT_EQ(std::minmax(warp->cross_from, warp->cross_to), std::minmax(1, 11));
  EXPECT_NEAR(warp->skew, 0, 1e-15);
  EXPECT_NEAR(warp->length, 0.1, 1e-15);
  EXPECT_NEAR(warp->width, 0.1, 1e-15);
  const auto* edge = bend_at(threads, 2, true);  // bottom edge: the inner neighbour is node 7
  ASSERT_TRUE(edge);
  EXPECT_EQ(std::minmax(edge->previous, edge->next), std::minmax(1, 3));
  EXPECT_TRUE((edge->cross_from == 2 && edge->cross_to == 7));
  EXPECT_NEAR(edge->width, 0.05, 1e-15);
}

TEST(Threads, ThreadAndSkewedCrossThreadFormARightHandedFrameWithTheNormal) {
  for (const auto& mesh : {skewed_sheet(), disc(0.15, 14), annulus(0.1, 0.2, 3, 17), rectangle(0.1, 0.4, 1, 4)}) {
    const auto normals = node_normals(mesh, mesh.reference);
    const auto threads = find_threads(mesh);
    ASSERT_FALSE(threads.bends.empty());
    for (const auto& b : threads.bends) {
      const auto x = [&](int i) { return mesh.reference[static_cast<std::size_t>(i)]; };
      const Vector3 along = x(b.next) - x(b.previous);
      const Vector3 across = x(b.cross_to) - x(b.cross_from) - b.skew * along;
      EXPECT_NEAR(across.dot(along), 0, 1e-15);
      EXPECT_GT(along.cross(across).normalized().dot(normals[static_cast<std::size_t>(b.centre)]), 0.8);
    }
  }
}

TEST(Threads, ThreadsEndAtTheFourIrregularNodesOfADisc) {
  const auto mesh = disc(0.15, 12);
  const auto threads = find_threads(mesh);
  std::vector<int> bends(static_cast<std::size_t>(mesh.nodes()), 0);
  for (const auto& b : threads.bends) ++bends[static_cast<std::size_t>(b.centre)];
  EXPECT_EQ(std::ranges::count(bends, 0), 4);
  EXPECT_EQ(std::ranges::count(bends, 1), std::ssize(mesh.sets.at("boundary")));
}

TEST(Threads, ARingClosesItsHoops) {
  const auto threads = find_threads(annulus(0.1, 0.2, 3, 16));
  EXPECT_EQ(threads.bends.size(), 16U * 2 + 2 * 16U * 2);  // hoops on the two edges; hoop and spoke on the two inside
}

TEST(Threads, EveryNodeListsItsThreadsAndWhereTheyGoOn) {
  const auto threads = find_threads(rectangle(0.4, 0.3, 4, 3));
  ASSERT_EQ(threads.end_start.size(), 21U);
  EXPECT_EQ(threads.ends_at(0).size(), 2U);
  for (const auto& end : threads.ends_at(0)) EXPECT_EQ(end.through, -1);
  EXPECT_EQ(threads.ends_at(2).size(), 3U);
  for (const auto& end : threads.ends_at(2)) EXPECT_EQ(end.through, end.neighbour == 7 ? -1 : 4 - end.neighbour);
  EXPECT_EQ(threads.ends_at(6).size(), 4U);
  for (const auto& end : threads.ends_at(6)) {
    EXPECT_EQ(end.through, 12 - end.neighbour);
    const auto& s = threads.segments[static_cast<std::size_t>(end.segment)];
    EXPECT_EQ(std::minmax(s.i, s.j), std::minmax(6, end.neighbour));
  }
}

TEST(Threads, PartsThatHangTogetherAtOneNodeAreRefused) {
  QuadMesh mesh;
  mesh.reference = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  for (const auto& x : mesh.reference) mesh.material.emplace_back(x.head<2>());
  mesh.quads = {{0, 1, 2, 3}, {2, 4, 5, 6}};
  EXPECT_THROW((void)find_threads(mesh), std::invalid_argument);
}

TEST(Threads, ThoseOfAPieceAreThoseOfItsSheet) {
  const std::array sheets{rectangle(0.3, 0.2, 3, 2), rectangle(0.2, 0.2, 2, 2)};  // 12 nodes, 9 nodes
  const auto all = find_threads(joined(sheets, std::array<std::string, 2>{"top", "lining"}));
  EXPECT_EQ(all.segments.size(), find_threads(sheets[0]).segments.size() + find_threads(sheets[1]).segments.size());
  for (int first = 0; const auto& sheet : sheets) {
    const int last = first + sheet.nodes();
    const auto own = find_threads(sheet), part = threads_between(all, first, last);
    ASSERT_EQ(part.segments.size(), own.segments.size());
    for (std::size_t k = 0; k < own.segments.size(); ++k) {
      EXPECT_EQ(part.segments[k].i, own.segments[k].i + first);
      EXPECT_EQ(part.segments[k].j, own.segments[k].j + first);
      EXPECT_EQ(part.segments[k].width, own.segments[k].width);
      EXPECT_EQ(part.segments[k].warp, own.segments[k].warp);
    }
    ASSERT_EQ(part.bends.size(), own.bends.size());
    for (std::size_t k = 0; k < own.bends.size(); ++k) {
      EXPECT_EQ(part.bends[k].previous, own.bends[k].previous + first);
      EXPECT_EQ(part.bends[k].centre, own.bends[k].centre + first);
      EXPECT_EQ(part.bends[k].next, own.bends[k].next + first);
    }
    for (int node = 0; node < 21; ++node) {
      const auto ends = part.ends_at(node);
      if (node < first || node >= last) {
        EXPECT_TRUE(ends.empty()) << node;
        continue;
      }
      const auto expected = own.ends_at(node - first);
      ASSERT_EQ(ends.size(), expected.size()) << node;
      for (std::size_t k = 0; k < ends.size(); ++k) {
        EXPECT_EQ(ends[k].neighbour, expected[k].neighbour + first);
        EXPECT_EQ(ends[k].through, expected[k].through < 0 ? -1 : expected[k].through + first);
        EXPECT_EQ(ends[k].segment, expected[k].segment);  // counted in the part
      }
    }
    first = last;
  }
}

}  // namespace
}  // namespace sundrape

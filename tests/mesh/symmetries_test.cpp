#include "sundrape/mesh/symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

/// How far the images of nodes lie from the nodes that they are said to be [m].
double worst_miss(const QuadMesh& mesh, const MeshSymmetry& symmetry) {
  const Vector3 c = centre_of_nodes(mesh);
  double worst = 0;
  for (std::size_t i = 0; i < mesh.reference.size(); ++i)
    worst = std::max(worst, (symmetry.rotation * (mesh.reference[i] - c) + c -
                             mesh.reference[static_cast<std::size_t>(symmetry.image[i])])
                                .norm());
  return worst;
}

/// Orders of the point groups: 4 turns and 4 reflections of a square, each with either side up; and so on.
TEST(Symmetries, OfFlatSheetsAreThoseOfTheirOutlineWithEitherSideUp) {
  EXPECT_EQ(mesh_symmetries(rectangle(0.2, 0.2, 6, 6)).size(), 16U);
  EXPECT_EQ(mesh_symmetries(rectangle(0.2, 0.1, 6, 6)).size(), 8U);
  EXPECT_EQ(mesh_symmetries(rectangle(0.2, 0.2, 6, 4)).size(), 8U);  // a square sheet of other cells
  EXPECT_EQ(mesh_symmetries(rectangle(0.06, 0.01, 24, 1)).size(), 8U);
  EXPECT_EQ(mesh_symmetries(disc(0.1, 8)).size(), 16U);  // its mesh has a square core
  EXPECT_EQ(mesh_symmetries(disc(0.1, 7)).size(), 16U);
  EXPECT_EQ(mesh_symmetries(annulus(0.05, 0.1, 3, 10)).size(), 40U);
}

TEST(Symmetries, OfCurvedSheetsDoNotTurnThemOver) {
  auto bowl = rectangle(0.2, 0.2, 6, 6), saddle = bowl, trough = bowl;
  for (auto& x : bowl.reference) x.z() = 3 * (x.x() * x.x() + x.y() * x.y());
  for (auto& x : saddle.reference) x.z() = 3 * (x.x() * x.x() - x.y() * x.y());
  for (auto& x : trough.reference) x.z() = 3 * x.x() * x.x();
  EXPECT_EQ(mesh_symmetries(bowl).size(), 8U);
  EXPECT_EQ(mesh_symmetries(saddle).size(), 8U);  // a quarter turn with the other side up
  EXPECT_EQ(mesh_symmetries(trough).size(), 4U);
}

TEST(Symmetries, AreIsometriesThatBringNodesToNodesAndFormAGroup) {
  for (const auto& mesh : {rectangle(0.2, 0.2, 5, 5), disc(0.1, 6), annulus(0.05, 0.1, 2, 7)}) {
    const auto all = mesh_symmetries(mesh);
    EXPECT_TRUE(all.front().rotation.isIdentity(1e-12));
    for (const auto& s : all) {
      EXPECT_LT((s.rotation * s.rotation.transpose() - Matrix3::Identity()).norm(), 1e-12);
      EXPECT_LT(worst_miss(mesh, s), 1e-12);
      for (const auto& t : all) {
        const Matrix3 product = s.rotation * t.rotation;
        const auto found =
            std::ranges::find_if(all, [&](const MeshSymmetry& u) { return (u.rotation - product).norm() < 1e-9; });
        ASSERT_NE(found, all.end());
        for (std::size_t i = 0; i < t.image.size(); ++i)
          ASSERT_EQ(found->image[i], s.image[static_cast<std::size_t>(t.image[i])]);
      }
    }
  }
}

TEST(Symmetries, BearRoundOffWhereverTheSheetStandsButNotIrregularity) {
  std::mt19937_64 bits(3);
  const auto shaken = [&](double amplitude) {
    auto mesh = rectangle(0.2, 0.2, 6, 6);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).matrix();
    for (auto& x : mesh.reference)
      x = turn * (x + Vector3(uniform(bits), uniform(bits), uniform(bits))) + Vector3(5, -3, 2);
    return mesh;
  };
  EXPECT_EQ(mesh_symmetries(shaken(1e-9)).size(), 16U);
  EXPECT_EQ(mesh_symmetries(shaken(1e-4)).size(), 1U);  // 0.05 % of the side
}

TEST(Symmetries, KeepQuadsTogether) {
  // One cell is missing, its corner node is not: only the diagonal through it is left.
  auto mesh = rectangle(0.2, 0.2, 2, 2);
  mesh.quads.erase(mesh.quads.begin());
  EXPECT_EQ(mesh_symmetries(mesh).size(), 4U);  // identity and one reflection, with either side up
}

TEST(Symmetries, OfALineAreRefused) {
  QuadMesh line;
  for (int i = 0; i < 5; ++i) line.reference.emplace_back(i, 0, 0);
  EXPECT_THROW((void)mesh_symmetries(line), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

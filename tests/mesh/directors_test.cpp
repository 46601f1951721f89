#include "sundrape/mesh/directors.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

/// A patch of a sphere of radius 2 about the origin, unevenly meshed, seen from outside.
QuadMesh patch_of_a_sphere(int cells_warp, int cells_weft) {
  auto mesh = rectangle(1.5, 1, cells_warp, cells_weft);
  for (auto& x : mesh.reference) {
    const double theta = x[0] + 0.2 * x[0] * x[0], phi = x[1] + 0.1 * x[0] * x[1];
    x = 2 * Vector3(std::sin(theta) * std::cos(phi), std::sin(phi), std::cos(theta) * std::cos(phi));
  }
  return mesh;
}

TEST(RestDirectors, AreTheNormalsOfASphereUpToItsBoundary) {
  const auto mesh = patch_of_a_sphere(6, 5);
  const auto directors = rest_directors(mesh);
  for (std::size_t i = 0; i < directors.size(); ++i)
    EXPECT_LE((directors[i] - mesh.reference[i].normalized()).norm(), 1e-12) << "node " << i;
}

TEST(RestDirectors, OfAFlatSheetAreItsNormalExactly) {
  for (const auto& mesh : {rectangle(0.2, 0.1, 4, 3), disc(0.1, 5), annulus(0.1, 0.2, 3, 12), rectangle(1, 1, 1, 1)})
    for (const auto& t : rest_directors(mesh)) EXPECT_LE((t - Vector3::UnitZ()).norm(), 1e-14);
}

TEST(RestDirectors, OfANarrowCylinderPointOutwardAtItsEndsToo) {
  auto mesh = rectangle(1, 0.1, 8, 1);
  for (auto& x : mesh.reference) x = Vector3(std::sin(x[0]), x[1], std::cos(x[0]));
  const auto directors = rest_directors(mesh);
  for (std::size_t i = 0; i < directors.size(); ++i) {
    const Vector3 exact(mesh.reference[i][0], 0, mesh.reference[i][2]);
    EXPECT_LE((directors[i] - exact).norm(), 1e-12);
  }
}

TEST(CarriedDirectors, TurnWithTheSheet) {
  const auto mesh = patch_of_a_sphere(4, 4);
  const auto directors = rest_directors(mesh);
  const Matrix3 turn = Eigen::AngleAxisd(0.01, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Vector3> moved;
  moved.reserve(mesh.reference.size());
  for (const auto& x : mesh.reference) moved.emplace_back(turn * x);
  const auto carried = carried_directors(mesh, directors, mesh.reference, moved);
  // a turn about the normal itself leaves no trace in it, so the two agree but for the turn times their lean
  for (std::size_t i = 0; i < carried.size(); ++i) EXPECT_LE((carried[i] - turn * directors[i]).norm(), 0.01 * 0.3);
  for (std::size_t i = 0; i < carried.size(); ++i)
    EXPECT_LE((carried_directors(mesh, directors, moved, moved)[i] - directors[i]).norm(), 1e-12);
}

}  // namespace
}  // namespace sundrape

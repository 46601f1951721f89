#include "sundrape/mesh/crossings.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

Vector flat(const std::vector<Vector3>& x) {
  Vector q(static_cast<Eigen::Index>(3 * x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) q.segment<3>(static_cast<Eigen::Index>(3 * i)) = x[i];
  return q;
}

TEST(Crossings, AFlatOrGentlyBentSheetHasNone) {
  const auto mesh = rectangle(0.1, 0.1, 12, 12);
  const SheetSurface surface(mesh);
  EXPECT_TRUE(crossings(surface, flat(mesh.reference)).empty());
  auto bent = mesh.reference;
  for (auto& x : bent) x = Vector3(0.04 * std::sin(x.x() / 0.04), x.y(), 0.04 * std::cos(x.x() / 0.04));
  EXPECT_TRUE(crossings(surface, flat(bent)).empty());
}

TEST(Crossings, ASheetRolledIntoItselfHasThemAlongALine) {
  // a spiral whose end has passed through its beginning: a roll of radius 3 cm, 10 % more than once around
  const auto mesh = rectangle(0.2, 0.1, 40, 8);
  const SheetSurface surface(mesh);
  auto rolled = mesh.reference;
  for (auto& x : rolled) {
    const double turn = 1.1 * 2 * M_PI * (x.x() / 0.2 + 0.5);
    const double radius = 0.03 + 0.004 * std::cos(turn / 1.1);  // the ends overlap, and their radii change order
    x = Vector3(radius * std::cos(turn) + 0.001 * turn * std::sin(turn), x.y(), radius * std::sin(turn));
  }
  const auto found = crossings(surface, flat(rolled));
  EXPECT_GE(found.size(), 8U);  // a line right across the sheet
  for (const auto& [a, b] : found) EXPECT_LT(a, b);
}

TEST(Crossings, TouchingByOneBitCountsAndMissingByOneBitDoesNot) {
  auto mesh = rectangle(1, 1, 1, 1);  // z = 0, from −½ to ½
  for (const auto& x : {Vector3(0.1, 0, 0), Vector3(0.3, 0, 1), Vector3(0.3, 0.2, 1), Vector3(0.1, 0.2, 1)}) {
    mesh.reference.push_back(x);
    mesh.material.emplace_back(0, 0);
  }
  mesh.quads.push_back({4, 5, 6, 7});
  const SheetSurface surface(mesh);
  auto q = flat(mesh.reference);
  EXPECT_FALSE(crossings(surface, q).empty());
  q[3 * 4 + 2] = 5e-324;
  EXPECT_TRUE(crossings(surface, q).empty());
}

}  // namespace
}  // namespace sundrape

#include "sundrape/mesh/interpolation.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

template <class Function>
Vector sampled(const QuadMesh& mesh, const Function& f) {
  Vector field(3 * mesh.nodes());
  for (int i = 0; i < mesh.nodes(); ++i) {
    const auto& x = mesh.material[static_cast<std::size_t>(i)];
    point(field, i) = f(x.x(), x.y());
  }
  return field;
}

template <class Function>
double largest_error(const QuadMesh& from, const QuadMesh& to, const Function& f) {
  return (SheetInterpolation(from, to).carry(sampled(from, f)) - sampled(to, f)).cwiseAbs().maxCoeff();
}

Vector3 linear(double x, double y) { return {x, 2 * x - 3 * y + 1, y}; }

TEST(SheetInterpolation, IsExactForLinearFieldsOnEveryShape) {
  EXPECT_LT(largest_error(rectangle(0.2, 0.1, 10, 4), rectangle(0.2, 0.1, 33, 7), linear), 1e-14);
  // on curved threads to the 1e-13 of the sheet's size to which places are found
  EXPECT_LT(largest_error(disc(0.1, 10), disc(0.1, 24), linear), 1e-12);
  EXPECT_LT(largest_error(annulus(0.05, 0.1, 4, 16), annulus(0.05, 0.1, 9, 40), linear), 1e-12);
}

// A parabola through three nodes has a quadratic field's slope, and a cubic with exact slopes at both ends is exact.
TEST(SheetInterpolation, IsExactForQuadraticFieldsOnGrids) {
  const auto f = [](double x, double y) { return Vector3(x * x, x * y, x * x - 2 * y * y + x); };
  EXPECT_LT(largest_error(rectangle(0.2, 0.1, 10, 4), rectangle(0.2, 0.1, 33, 8), f), 1e-15);
}

TEST(SheetInterpolation, KeepsValuesWhereNodesCoincide) {
  const auto coarse = rectangle(0.2, 0.2, 6, 6), fine = rectangle(0.2, 0.2, 12, 12);
  const auto f = [](double x, double y) { return Vector3(std::sin(40 * x), std::cos(30 * y), std::sin(20 * x * y)); };
  const auto carried = SheetInterpolation(coarse, fine).carry(sampled(coarse, f));
  const auto exact = sampled(fine, f);
  for (int iy = 0; iy <= 12; iy += 2)
    for (int ix = 0; ix <= 12; ix += 2)
      EXPECT_LT((point(carried, 13 * iy + ix) - point(exact, 13 * iy + ix)).norm(), 1e-15);
}

// Cubic Hermite with slopes of order two is of order three (Keys 1981); linear interpolation would be of order two.
TEST(SheetInterpolation, ConvergesWithOrderThree) {
  const auto f = [](double x, double y) { return Vector3(std::sin(20 * x), std::cos(15 * y), std::sin(10 * (x + y))); };
  const auto fine = rectangle(0.2, 0.2, 77, 77);
  const double e1 = largest_error(rectangle(0.2, 0.2, 16, 16), fine, f);
  const double e2 = largest_error(rectangle(0.2, 0.2, 32, 32), fine, f);
  EXPECT_GT(std::log2(e1 / e2), 2.8);
}

TEST(SheetInterpolation, ReachesTheRimThatACoarserPolygonCutsOff) {
  const auto coarse = disc(0.1, 8), fine = disc(0.1, 40);
  const auto place = [](double x, double y) { return Vector3(x, y, 0); };
  EXPECT_LT(largest_error(coarse, fine, place), 1e-12);
}

TEST(SheetInterpolation, RefusesAnotherSheet) {
  EXPECT_THROW(SheetInterpolation(rectangle(0.1, 0.1, 4, 4), rectangle(0.2, 0.1, 8, 4)), std::invalid_argument);
  const auto mesh = rectangle(0.1, 0.1, 4, 4);
  EXPECT_THROW((void)SheetInterpolation(mesh, mesh).carry(Vector::Zero(3)), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

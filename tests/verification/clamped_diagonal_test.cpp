// A cloth clamped along its diagonal bends at 45° to its mesh, where membrane fields that see a bent cell as stretched
// lock (the trial of membrane fields behind the choice of `shell.membrane`).
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

// A triangle that bends as a cylinder, clamped at its base: the shooting of diagonal_rod_test.cpp from θ = 0 with a
// free moment there. Its free edges would flare, so the cloth hangs a little steeper.
constexpr double triangle = 0.01146;  // x of the corner [m]

double corner(const std::string& membrane, int cells) {
  const auto b =
      benchmark("clamped_diagonal.toml", {fmt::format("cloth.cells=[{0},{0}]", cells), "shell.membrane=" + membrane});
  const auto rest = equilibrium(b);
  const Vector3 here = point(rest.q, b.model.probes.at(0).node);
  EXPECT_NEAR(here.x(), -here.y(), 1e-4) << "the cloth is symmetric";
  fmt::print("{} {}²: corner x {:.3f} cm, z {:.3f} cm; {} iterations\n", membrane, cells, 100 * here.x(),
             100 * here.z(), rest.result.iterations);
  return here.x();
}

// Within 1 % of the side, which no other field is at 10².
constexpr double coarse_tolerance = 0.002;

TEST(ClampedDiagonal, DefaultFieldDoesNotLockOnTenCells) {
  EXPECT_NEAR(corner("centre", 10), triangle, coarse_tolerance);
  EXPECT_GT(corner("mixed", 10), triangle + coarse_tolerance);
}

TEST(ClampedDiagonalVerification, DefaultFieldHangsWhereItShouldOnEveryMesh) {
  for (const int cells : {10, 20, 40}) EXPECT_NEAR(corner("centre", cells), triangle, coarse_tolerance) << cells;
}

// All fields are the same shell in the limit; the others come to it from above.
TEST(ClampedDiagonalVerification, OtherFieldsComeToTheSameFromAbove) {
  for (const std::string field : {"mixed", "bilinear", "edge-tied"}) {
    const double coarse = corner(field, 10), middle = corner(field, 20), fine = corner(field, 40);
    EXPECT_GT(coarse, middle) << field;
    EXPECT_GT(middle, fine) << field;
    EXPECT_NEAR(fine, triangle, coarse_tolerance) << field;
  }
}

}  // namespace
}  // namespace sundrape

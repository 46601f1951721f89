// The reference solutions of bent strips, checked without any cloth: against published numbers, against a chain of
// rigid links and against a first integral.
#include "support/planar_elastica.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"
#include "support/rigid_chain.hpp"
#include "support/twill.hpp"

namespace sundrape {
namespace {

constexpr double length = 0.1;  // of the strips of twill [m]

PlanarElastica heavy_twill(double weight = twill::weight) {
  return {.law = twill::law(), .length = length, .weight = weight};
}
RigidChain chain_of_twill() {
  return {.moment = twill::moment, .slope = twill::slope, .length = length, .weight = twill::weight};
}

TEST(PlanarElastica, LawIsThePolynomialWrittenOut) {
  const auto law = twill::law();
  for (double k = 0.5; k <= twill::max_curvature; k += 0.5) {
    const auto f = law.at(k), back = law.at(-k);
    EXPECT_NEAR(f.moment, twill::moment(k), 1e-13 * f.moment);
    EXPECT_NEAR(f.slope, twill::slope(k), 1e-12 * law.initial_rigidity());
    EXPECT_NEAR(f.energy, twill::energy(k), 1e-13 * f.energy);
    EXPECT_EQ(back.moment, -f.moment);
    EXPECT_EQ(back.energy, f.energy);
  }
}

TEST(PlanarElastica, AgreesWithTheTableOfTipForces) {
  const auto table = reference_table("elastica_tip_force.csv");
  for (std::size_t k = 0; k < table.at("lambda").size(); ++k) {
    const PlanarElastica strip{.law = MomentCurvature::linear(1), .tip_force = {0, table.at("lambda")[k]}};
    const auto shape = strip.solve();
    EXPECT_NEAR(1 - shape.tip.x(), table.at("ux/L (shortening)")[k], 1e-8);
    EXPECT_NEAR(shape.tip.y(), table.at("uy/L")[k], 1e-8);
    EXPECT_NEAR(shape.tip_angle, table.at("tip rotation rad")[k], 1e-8);
    EXPECT_LE(shape.error, 1e-8);
  }
}

TEST(PlanarElastica, SagsLikeABeamUnderLittleWeight) {
  // w L⁴/8B with relative corrections of the order of the squared slope
  const auto shape = PlanarElastica{.law = MomentCurvature::linear(2), .length = 3, .weight = 1e-6}.solve();
  EXPECT_NEAR(shape.tip.y(), -1e-6 * 81 / 16, 1e-9 * 1e-6);
  EXPECT_NEAR(shape.root_moment, -1e-6 * 9 / 2, 1e-9 * 1e-6);
}

TEST(PlanarElastica, OfHeavyTwillIsTheLimitOfFinerChains) {
  const auto exact = heavy_twill().solve();
  const auto chain = chain_of_twill();
  const Eigen::Vector2d coarse = chain.tip(1000), fine = chain.tip(2000), limit = (4 * fine - coarse) / 3;
  fmt::print(
      "tip at ({:.8f}, {:.8f}) cm, slope {:.8f} rad, root curvature {:.6f} /cm; own error {:.1e} L, chain's "
      "limit {:.1e} L away\n",
      100 * exact.tip.x(), 100 * exact.tip.y(), exact.tip_angle, 0.01 * exact.root_curvature, exact.error / length,
      (exact.tip - limit).norm() / length);
  EXPECT_LE((exact.tip - limit).norm(), 1e-8 * length);
  EXPECT_LE(exact.error, 1e-8 * length);
}

TEST(PlanarElastica, KeepsItsFirstIntegralUnderATipForce) {
  // K f(K) − ∫f dK + F · (cos θ, sin θ) is the same all along a strip without weight
  const PlanarElastica strip{.law = twill::law(), .length = length, .tip_force = {-0.03, -0.05}, .clamp_angle = 0.4};
  const auto shape = strip.solve();
  const auto along = [&](double angle) {
    return strip.tip_force.dot(Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  };
  const double k = std::abs(shape.root_curvature), root = k * twill::moment(k) - twill::energy(k);
  EXPECT_LT(k, twill::max_curvature);
  EXPECT_GT(std::abs(shape.tip_angle - strip.clamp_angle), 0.3);
  EXPECT_NEAR(root + along(strip.clamp_angle), along(shape.tip_angle), 1e-9 * strip.tip_force.norm());
  // the moment of the force about the clamp
  EXPECT_NEAR(shape.root_moment, shape.tip.x() * strip.tip_force.y() - shape.tip.y() * strip.tip_force.x(),
              1e-9 * length);
}

TEST(PlanarElastica, StaysAccurateWhereTheFitEnds) {
  const auto shape = heavy_twill(8 * twill::weight).solve();
  EXPECT_GT(std::abs(shape.root_curvature), twill::max_curvature);
  EXPECT_LE(shape.error, 1e-6 * length);
}

TEST(PlanarElastica, HangsStraightFromAVerticalClamp) {
  auto strip = heavy_twill();
  strip.clamp_angle = -0.5 * std::numbers::pi;
  const auto shape = strip.solve();
  EXPECT_NEAR(shape.tip.x(), 0, 1e-12);
  EXPECT_NEAR(shape.tip.y(), -length, 1e-12);
}

}  // namespace
}  // namespace sundrape

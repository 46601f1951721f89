#include "sundrape/material/moment_curvature.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "twill.hpp"

namespace sundrape {
namespace {

/// Σ α_k K^k of the article, for K inside its range.
double twill_by_hand(double k) {
  double moment = 0;
  for (std::size_t i = 0; i < twill_coefficients.size(); ++i)
    moment += twill_coefficients[i] * std::pow(k, static_cast<double>(i + 1));
  return moment;
}

TEST(MomentCurvature, OfTheTwillIsThePolynomialOfTheArticle) {
  const auto law = twill();
  EXPECT_FALSE(law.is_linear());
  EXPECT_EQ(law.initial_rigidity(), 1.33387);
  for (const double k : {0.0, 0.1, 0.55, 1.2, 1.89, 2.5}) EXPECT_NEAR(law.at(k).moment, twill_by_hand(k), 1e-14) << k;
  // the article's tangents: steep at first, softest near 0.55 /cm and near 1.89 /cm
  EXPECT_NEAR(law.at(0.0).slope, 1.334, 5e-4);
  EXPECT_NEAR(law.at(0.55).slope, 0.39, 5e-3);
  EXPECT_NEAR(law.at(1.2).slope, 0.55, 5e-3);
  EXPECT_NEAR(law.at(1.89).slope, 0.36, 5e-3);
}

TEST(MomentCurvature, IsOdd) {
  const auto law = twill();
  for (const double k : {0.0, 1e-9, 0.3, 1.7, 2.5, 4.0}) {
    EXPECT_EQ(law.at(-k).moment, -law.at(k).moment) << k;
    EXPECT_EQ(law.at(-k).slope, law.at(k).slope) << k;
    EXPECT_EQ(law.at(-k).energy, law.at(k).energy) << k;
  }
  EXPECT_EQ(law.at(0.0).moment, 0);
  EXPECT_EQ(law.at(0.0).energy, 0);
}

TEST(MomentCurvature, HasTheMomentAsSlopeOfItsEnergyAndTheSlopeAsThatOfItsMoment) {
  const auto law = twill();
  constexpr double step = 1e-5;
  // inside, at K_max (where the slope goes on without a jump), and past it, on either side of zero
  for (const double k : {-3.1, -2.5, -1.0, -0.2, 0.2, 0.55, 1.3, 2.0, 2.5, 2.6, 5.0}) {
    const auto low = law.at(k - step), here = law.at(k), high = law.at(k + step);
    EXPECT_NEAR((high.energy - low.energy) / (2 * step), here.moment, 1e-8) << k;
    // second derivatives jump at K_max, which costs the central difference one order
    EXPECT_NEAR((high.moment - low.moment) / (2 * step), here.slope, std::abs(k) == 2.5 ? 1e-4 : 1e-8) << k;
  }
}

TEST(MomentCurvature, GoesOnPastItsRangeByTheSlopeThere) {
  const auto law = twill();
  const auto end = law.at(2.5);
  for (const double beyond : {0.1, 1.0, 100.0}) {
    const auto r = law.at(2.5 + beyond);
    EXPECT_DOUBLE_EQ(r.slope, end.slope);
    EXPECT_DOUBLE_EQ(r.moment, end.moment + end.slope * beyond);
    EXPECT_DOUBLE_EQ(r.energy, end.energy + end.moment * beyond + 0.5 * end.slope * beyond * beyond);
  }
}

TEST(MomentCurvature, OfALinearStripIsHookesLaw) {
  const auto law = MomentCurvature::linear(0.589);
  EXPECT_TRUE(law.is_linear());
  for (const double k : {-300.0, -0.7, 0.0, 2.0, 1e6}) {
    EXPECT_DOUBLE_EQ(law.at(k).moment, 0.589 * k);
    EXPECT_DOUBLE_EQ(law.at(k).slope, 0.589);
    EXPECT_DOUBLE_EQ(law.at(k).energy, 0.5 * 0.589 * k * k);
  }
  const auto same = MomentCurvature::polynomial(std::vector{0.589}, 1);
  EXPECT_DOUBLE_EQ(same.at(7.0).moment, 0.589 * 7);
}

TEST(MomentCurvature, RefusesLawsThatNoStripHas) {
  const auto refused = [](const std::vector<double>& coefficients, double max) {
    EXPECT_THROW((void)MomentCurvature::polynomial(coefficients, max), std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({}, 1);
  refused(std::vector<double>(10, 1.0), 1);
  refused({1, nan}, 1);
  refused({1}, 0);
  refused({1}, nan);
  refused({-1}, 1);
  refused({0, 1}, 1);         // no slope at the origin
  refused({1, -0.5}, 1.001);  // slope 1 - K: turns back at K = 1
  EXPECT_NO_THROW((void)MomentCurvature::polynomial(std::vector{1.0, -0.5}, 0.999));
  refused({1, -1.5, 0.7}, 2);  // slope 1 - 3 K + 2.1 K²: falls between 0.53 and 0.89, rises again
  EXPECT_NO_THROW((void)MomentCurvature::polynomial(std::vector(9, 1.0), 1));
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW((void)MomentCurvature::linear(bad), std::invalid_argument) << bad;
}

}  // namespace
}  // namespace sundrape

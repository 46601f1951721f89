#include "sundrape/app/least_squares.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

LeastSquaresOptions unbounded(int parameters) {
  return {.lower = Vector::Constant(parameters, -infinity),
          .upper = Vector::Constant(parameters, infinity),
          .scale = Vector::Ones(parameters),
          .tolerance = 1e-8,
          .max_iterations = 100};
}

const auto keep_going = [](const LeastSquaresStep&) { return true; };

/// Rosenbrock's valley, r = (10 (y − x²), 1 − x): its least value is 0 at (1, 1).
std::optional<LeastSquaresPoint> valley(const Vector& at) {
  LeastSquaresPoint p{Vector(2), Eigen::MatrixXd(2, 2)};
  p.residuals << 10 * (at[1] - at[0] * at[0]), 1 - at[0];
  p.jacobian << -20 * at[0], 10, -1, 0;
  return p;
}

TEST(LeastSquares, FindsTheEndOfABentValley) {
  const auto found = minimise(Eigen::Vector2d(-1.2, 1), unbounded(2), valley, keep_going);
  EXPECT_EQ(found.end, LeastSquaresResult::End::converged);
  EXPECT_NEAR(found.at[0], 1, 1e-5);  // to 1e-5 of the parameters' size the search goes on
  EXPECT_NEAR(found.at[1], 1, 2e-5);
}

TEST(LeastSquares, StaysWithinItsBounds) {
  auto options = unbounded(2);
  options.upper[0] = 0.5;  // where y = x² and the valley ends
  const auto found = minimise(Eigen::Vector2d(-1.2, 1), options, valley, keep_going);
  EXPECT_EQ(found.end, LeastSquaresResult::End::converged);
  EXPECT_NEAR(found.at[0], 0.5, 1e-12);
  EXPECT_NEAR(found.at[1], 0.25, 1e-4);
}

TEST(LeastSquares, ShortensStepsToWhereTheModelHasNoAnswer) {
  const auto root = [](const Vector& at) -> std::optional<LeastSquaresPoint> {  // ln x = 0
    if (!(at[0] > 0)) return std::nullopt;
    return LeastSquaresPoint{Vector::Constant(1, std::log(at[0])), Eigen::MatrixXd::Constant(1, 1, 1 / at[0])};
  };
  const auto found = minimise(Vector::Constant(1, 5), unbounded(1), root, keep_going);  // Gauss–Newton: 5 − 8.05
  EXPECT_NEAR(found.at[0], 1, 1e-4);
}

TEST(LeastSquares, StopsWhenAskedTo) {
  const auto found = minimise(Eigen::Vector2d(-1.2, 1), unbounded(2), valley,
                              [](const LeastSquaresStep& step) { return step.iteration < 3; });
  EXPECT_EQ(found.end, LeastSquaresResult::End::stopped);
  EXPECT_EQ(found.iterations, 3);
}

TEST(LeastSquares, UncertaintyIsThatOfAStraightLine) {
  // y = a + b x at x = 0 … 4 with residuals (1, −1, 0, −1, 1): s² = 4/3, Var b = s²/10, Var a = s² (1/5 + 4/10),
  // Cov = −2 s²/10; t(3; 0.975) = 3.182446
  LeastSquaresPoint line{Vector(5), Eigen::MatrixXd(5, 2)};
  line.residuals << 1, -1, 0, -1, 1;
  for (int i = 0; i < 5; ++i) line.jacobian.row(i) << 1, i;
  const auto u = uncertainty(line, 0.95);
  EXPECT_TRUE(u.by_residuals);
  EXPECT_NEAR(u.residual_variance, 4.0 / 3, 1e-12);
  EXPECT_NEAR(u.standard_error[0], std::sqrt(0.8), 1e-12);
  EXPECT_NEAR(u.standard_error[1], std::sqrt(4.0 / 30), 1e-12);
  EXPECT_NEAR(u.correlation(0, 1), -0.2 / std::sqrt(0.6 * 0.1), 1e-12);
  EXPECT_NEAR(u.quantile, 3.182446, 1e-6);
}

TEST(LeastSquares, SaysThatACombinationIsNotTold) {
  LeastSquaresPoint twice{Vector::Ones(3), Eigen::MatrixXd::Ones(3, 2)};
  const auto u = uncertainty(twice, 0.95);
  EXPECT_LT(u.reciprocal_condition, 1e-14);
  EXPECT_EQ(u.standard_error[0], infinity);
}

}  // namespace
}  // namespace sundrape

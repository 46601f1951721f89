#include "sundrape/mesh/keyframes.hpp"

#include <gtest/gtest.h>

namespace sundrape {
namespace {

Eigen::MatrixXd row(std::initializer_list<double> values) {
  Eigen::MatrixXd m(1, static_cast<Eigen::Index>(values.size()));
  Eigen::Index k = 0;
  for (const double v : values) m(0, k++) = v;
  return m;
}

TEST(Keyframes, GoThroughTheirValuesAndStayAtTheirEnds) {
  for (const auto between : {Keyframes::Between::straight, Keyframes::Between::smooth}) {
    const Keyframes k({1, 2, 4}, row({3, 5, -1}), between);
    EXPECT_DOUBLE_EQ(k.value(0)[0], 3);
    EXPECT_DOUBLE_EQ(k.value(1)[0], 3);
    EXPECT_NEAR(k.value(2)[0], 5, 1e-14);
    EXPECT_NEAR(k.value(4)[0], -1, 1e-14);
    EXPECT_NEAR(k.value(9)[0], -1, 1e-14);
    EXPECT_EQ(k.rate(0.5)[0], 0);
    EXPECT_EQ(k.rate(4.5)[0], 0);
  }
}

TEST(Keyframes, AreStraightBetweenOrSmoothAndAtRestAtTheEnds) {
  const Keyframes straight({0, 1, 3}, row({0, 2, -2}), Keyframes::Between::straight);
  EXPECT_DOUBLE_EQ(straight.value(0.25)[0], 0.5);
  EXPECT_DOUBLE_EQ(straight.rate(2)[0], -2);
  // one leg from rest to rest is x²(3 − 2x)
  const Keyframes one({0, 2}, row({0, 1}), Keyframes::Between::smooth);
  EXPECT_NEAR(one.value(0.5)[0], 0.0625 * 2.5, 1e-14);
  const Keyframes smooth({0, 1, 3}, row({0, 2, -2}), Keyframes::Between::smooth);
  EXPECT_NEAR(smooth.rate(0)[0], 0, 1e-14);
  EXPECT_NEAR(smooth.rate(3 - 1e-12)[0], 0, 1e-10);
  const auto second = [&](double t, double h) { return (smooth.rate(t + h)[0] - smooth.rate(t)[0]) / h; };
  EXPECT_NEAR(second(1, 1e-6), second(1, -1e-6), 1e-4);  // C² at the middle
}

TEST(Keyframes, HaveTheRateOfTheirValue) {
  const Keyframes k({0, 0.7, 1.9, 2}, row({0, 2, -2, 1}), Keyframes::Between::smooth);
  for (const double t : {0.1, 0.69, 0.71, 1.5, 1.95}) {
    const double h = 1e-5;
    EXPECT_NEAR(k.rate(t)[0], (k.value(t + h)[0] - k.value(t - h)[0]) / (2 * h), 1e-5 * (1 + std::abs(k.rate(t)[0])));
  }
}

TEST(Keyframes, RefuseTimesThatDoNotAscend) {
  EXPECT_THROW(Keyframes({0, 1, 1}, row({0, 1, 2}), Keyframes::Between::smooth), std::invalid_argument);
  EXPECT_THROW(Keyframes({0}, row({0}), Keyframes::Between::smooth), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

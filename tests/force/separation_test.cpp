#include "sundrape/force/separation.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

using Four = std::array<Vector3, 4>;

Four random_points(std::mt19937& random) {
  std::uniform_real_distribution<> uniform(-1, 1);
  Four x;
  for (auto& p : x) p = Vector3(uniform(random), uniform(random), uniform(random));
  return x;
}

/// Least distance by trying: points on both shapes of a grid of parameters.
double tried(Shapes shapes, const Four& x, int parts) {
  double least = 1e300;
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; j <= parts; ++j) {
      const double s = static_cast<double>(i) / parts, t = static_cast<double>(j) / parts;
      Vector3 a = x[0], b = x[1];
      if (shapes == Shapes::point_edge) b = x[1] + s * (x[2] - x[1]);
      if (shapes == Shapes::point_triangle) {
        if (s + t > 1) continue;
        b = x[1] + s * (x[2] - x[1]) + t * (x[3] - x[1]);
      }
      if (shapes == Shapes::edge_edge) {
        a = x[0] + s * (x[1] - x[0]);
        b = x[2] + t * (x[3] - x[2]);
      }
      least = std::min(least, (a - b).norm());
    }
  return least;
}

constexpr std::array every_kind{Shapes::point_point, Shapes::point_edge, Shapes::point_triangle, Shapes::edge_edge};

TEST(Separation, IsTheLeastDistanceOfAllPoints) {
  std::mt19937 random(3);
  for (const auto shapes : every_kind)
    for (int i = 0; i < 60; ++i) {
      const auto x = random_points(random);
      const auto s = separation(shapes, x);
      const double least = tried(shapes, x, 60);
      EXPECT_LE(s.distance, least + 1e-12);
      EXPECT_GE(s.distance, least - 2 * std::sqrt(2.0) / 60);
      Vector3 way = Vector3::Zero();
      for (std::size_t k = 0; k < 4; ++k) way += s.weights[k] * x[k];
      EXPECT_NEAR(way.norm(), s.distance, 1e-14);
    }
}

TEST(Separation, DerivativesAreThoseOfFiniteDifferences) {
  constexpr double step = 1e-4;
  std::mt19937 random(5);
  for (const auto shapes : every_kind)
    for (int i = 0; i < 40; ++i) {
      const auto x = random_points(random);
      const auto s = separation(shapes, x);
      const SeparationHessian hessian(s, x);
      const auto gradient = [&](const Four& at, std::size_t k) -> Vector3 {  // of half the squared distance
        const auto there = separation(shapes, at);
        return there.weights[k] * there.way;
      };
      for (std::size_t l = 0; l < points_of(shapes); ++l)
        for (int c = 0; c < 3; ++c) {
          auto ahead = x, behind = x;
          ahead[l][c] += step;
          behind[l][c] -= step;
          if (separation(shapes, ahead).slides != s.slides || separation(shapes, behind).slides != s.slides)
            continue;  // the derivative jumps where an end reaches a corner
          for (std::size_t k = 0; k < points_of(shapes); ++k) {
            const Vector3 slope = (gradient(ahead, k) - gradient(behind, k)) / (2 * step);
            EXPECT_LE((slope - hessian.block(k, l).col(c)).norm(), 1e-4 * (1 + slope.norm()))
                << "kind " << static_cast<int>(shapes) << ", trial " << i;
          }
        }
    }
}

TEST(Separation, AnObtuseTrianglesCornerCanBeNearest) {
  const auto s = separation(Shapes::point_triangle, {Vector3(3, 0.1, 0), {0, 0, 0}, {1, 0, 0}, {-1, 0.2, 0}});
  EXPECT_EQ(s.slides, 0);
  EXPECT_NEAR(s.distance, std::hypot(2, 0.1), 1e-14);
}

TEST(Separation, ParallelEdgesAreApartByTheirDistance) {
  EXPECT_NEAR(separation(Shapes::edge_edge, {Vector3(0, 0, 0), {1, 0, 0}, {0.5, 0.3, 0}, {1.5, 0.3, 0}}).distance, 0.3,
              1e-14);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/app/drapes.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

using Members = std::vector<std::size_t>;

/// Distances of states that stand on a line.
Eigen::MatrixXd on_a_line(const std::vector<double>& places) {
  const auto n = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd apart(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      apart(i, j) = std::abs(places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)]);
  return apart;
}

TEST(Drapes, ComeByCountThenByEnergy) {
  const auto drapes = sort_into_drapes(on_a_line({5, 0, 0.1, 9, 0.2, 9.1, 5.05}), {1, 4, 3, 7, 5, 6, 2}, 0.5);
  ASSERT_EQ(drapes.size(), 3U);
  EXPECT_EQ(drapes[0].members, (Members{1, 2, 4}));
  EXPECT_EQ(drapes[0].representative, 2U);  // of least energy
  EXPECT_NEAR(drapes[0].spread, 0.1, 1e-15);
  EXPECT_EQ(drapes[1].members, (Members{0, 6}));  // two each: least energies 1 and 6
  EXPECT_EQ(drapes[2].members, (Members{3, 5}));
  EXPECT_EQ(drapes[2].representative, 5U);
}

TEST(Drapes, AreLinkedByWhatLiesBetweenInAnyOrder) {
  EXPECT_EQ(sort_into_drapes(on_a_line({0, 0.8, 0.4}), {0, 0, 0}, 0.5).size(), 1U);
  EXPECT_EQ(sort_into_drapes(on_a_line({0.4, 0, 0.8}), {0, 0, 0}, 0.5).size(), 1U);
  EXPECT_EQ(sort_into_drapes(on_a_line({0, 0.8}), {0, 0}, 0.5).size(), 2U);
}

TEST(Drapes, OfNothingAreNone) { EXPECT_TRUE(sort_into_drapes(Eigen::MatrixXd(0, 0), {}, 1).empty()); }

}  // namespace
}  // namespace sundrape

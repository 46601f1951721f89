#include "sundrape/mesh/box_pairs.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/types.hpp"

namespace sundrape {
namespace {

TEST(BoxPairs, AreAllThatOverlap) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int i = 0; i < 300; ++i) {
    const auto wave = [i](double rate) { return std::sin(rate * (i + 1)); };
    const Vector3 low(wave(1.3), wave(2.7), wave(4.1));
    boxes.emplace_back(low, Vector3(low + 0.15 * Vector3(1 + wave(5), 1 + wave(7), 1 + wave(11))));
  }
  std::vector<std::pair<int, int>> expected;
  for (int i = 0; i < 300; ++i)
    for (int j = i + 1; j < 300; ++j)
      if (boxes[static_cast<std::size_t>(i)].intersects(boxes[static_cast<std::size_t>(j)]))
        expected.emplace_back(i, j);
  EXPECT_GT(expected.size(), 50U);
  EXPECT_EQ(overlapping_pairs(boxes), expected);
}

}  // namespace
}  // namespace sundrape

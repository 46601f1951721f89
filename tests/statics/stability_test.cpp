#include "sundrape/statics/stability.hpp"

#include <gtest/gtest.h>

#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

// A hanging mass on a spring has one stiff direction, and two in which tension over length holds it; under compression
// those two fall over.
TEST(Stability, CountsTheDirectionsInWhichACompressedSpringFallsOver) {
  const Vector still = Vector::Zero(6);
  for (const auto& [stretch, unstable] : {std::pair{0.01, 0}, {-0.01, 2}}) {
    const auto system = mass_on_spring(0);
    const Vector q = below(stretch);
    EXPECT_EQ(negative_pivots(system, {0, q, still}, 1e-3), unstable) << stretch;
  }
}

TEST(Stability, NeutralMotionIsNotCounted) {
  const auto system = mass_on_spring(0);  // unstretched: free to swing
  EXPECT_EQ(negative_pivots(system, {0, below(), Vector::Zero(6)}, 1e-3), 0);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/integrate/error_weights.hpp"

#include <gtest/gtest.h>

namespace sundrape {
namespace {

TEST(ErrorWeights, CountFromWhereAPointStartedAndAreTheSameForItsComponents) {
  const ErrorWeights weights{.rtol = 1e-3, .atol_position = 1e-5, .atol_velocity = 2e-3, .start = Vector3(5, 6, 7)};
  Vector y(6), w(6);
  y << 5.3, 6, 7.4, 0, 3, 4;  // 0.5 m from the start, at 5 m/s
  weights.evaluate(y, w);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(1 / w[k], 1e-3 * 0.5 + 1e-5, 1e-12);
    EXPECT_NEAR(1 / w[3 + k], 1e-3 * 5 + 2e-3, 1e-12);
  }
}

}  // namespace
}  // namespace sundrape

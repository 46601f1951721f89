#include "sundrape/mesh/quad_locator.hpp"

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

Eigen::Vector2d bilinear(const QuadMesh& mesh, const QuadLocator::Place& place) {
  const auto& quad = mesh.quads[static_cast<std::size_t>(place.quad)];
  const double x = place.at.x(), y = place.at.y();
  const double weight[] = {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
  Eigen::Vector2d sum(0, 0);
  for (std::size_t k = 0; k < 4; ++k) sum += weight[k] * mesh.material[static_cast<std::size_t>(quad[k])];
  return sum;
}

TEST(QuadLocator, FindsTheQuadAndThePlaceInIt) {
  for (const auto& mesh : {rectangle(0.3, 0.1, 7, 3), disc(0.1, 9), annulus(0.02, 0.1, 5, 17)}) {
    const QuadLocator locator(mesh);
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
      const QuadLocator::Place place{static_cast<int>(q), {0.3, 0.6}};
      const auto found = locator.find(bilinear(mesh, place));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->quad, place.quad);
      EXPECT_LT((found->at - place.at).norm(), 1e-10);
    }
  }
}

TEST(QuadLocator, FindsWhatLiesALittleOffTheSheetAndNothingFarther) {
  const auto mesh = rectangle(0.4, 0.4, 4, 4);
  const QuadLocator locator(mesh);
  const auto off = locator.find({0.22, 0.05});  // a fifth of a cell
  ASSERT_TRUE(off);
  EXPECT_NEAR(off->at.x(), 1.2, 1e-12);
  EXPECT_FALSE(locator.find({0.24, 0.05}));
  EXPECT_FALSE(locator.find({5, 5}));
}

}  // namespace
}  // namespace sundrape

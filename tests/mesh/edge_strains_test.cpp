#include "sundrape/mesh/edge_strains.hpp"

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

TEST(EdgeStrains, AreTheSmallestAndLargestOfAllEdges) {
  const auto mesh = rectangle(0.04, 0.02, 2, 1);
  const EdgeStrains strains(mesh);
  Vector q(3 * mesh.nodes() + 3);  // what follows the nodes is not read
  q.setConstant(1e6);
  for (int i = 0; i < mesh.nodes(); ++i) point(q, i) = mesh.reference[static_cast<std::size_t>(i)];
  EXPECT_EQ(strains.range(q), (std::pair{0.0, 0.0}));
  for (int i = 0; i < mesh.nodes(); ++i) point(q, i).x() *= 1.03, point(q, i).y() *= 0.98;
  EXPECT_NEAR(strains.range(q).first, -0.02, 1e-14);
  EXPECT_NEAR(strains.range(q).second, 0.03, 1e-14);
}

}  // namespace
}  // namespace sundrape

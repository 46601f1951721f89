#include "sundrape/mesh/joined.hpp"

#include <array>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

const std::array<std::string, 2> names{"top", "lining"};
const std::array<QuadMesh, 2> sheets{rectangle(0.3, 0.2, 3, 2), rectangle(0.1, 0.1, 1, 1)};  // 12 nodes, 4 nodes

TEST(Joined, HasTheNodesAndQuadsOfOneSheetAfterTheOther) {
  const auto whole = joined(sheets, names);
  ASSERT_EQ(whole.nodes(), 16);
  ASSERT_EQ(whole.quads.size(), 7U);
  EXPECT_EQ(whole.reference[11], sheets[0].reference[11]);
  EXPECT_EQ(whole.reference[12], sheets[1].reference[0]);
  EXPECT_EQ(whole.material[15], sheets[1].material[3]);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(whole.quads[6][k], sheets[1].quads[0][k] + 12);
  EXPECT_NO_THROW(require_sound(whole));
}

TEST(Joined, SetsAreThoseOfAllAndThoseOfEach) {
  const auto whole = joined(sheets, names);
  EXPECT_EQ(whole.sets.at("lining"), (std::vector<int>{12, 13, 14, 15}));
  EXPECT_EQ(whole.sets.at("lining.bottom_left"), std::vector<int>{12});
  EXPECT_EQ(whole.sets.at("top.bottom_left"), std::vector<int>{0});
  EXPECT_EQ(whole.sets.at("bottom_left"), (std::vector<int>{0, 12}));
}

TEST(Joined, PiecesSayWhereEachStands) {
  const auto pieces = pieces_of(sheets, names);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].first_node, 0);
  EXPECT_EQ(pieces[1].first_node, 12);
  EXPECT_EQ(pieces[1].first_quad, 6);
  EXPECT_TRUE(pieces[1].has_node(12));
  EXPECT_FALSE(pieces[1].has_node(11));
  const auto lining = only(joined(sheets, names), pieces[1]);
  EXPECT_EQ(lining.nodes(), 16);
  ASSERT_EQ(lining.quads.size(), 1U);
  EXPECT_EQ(lining.quads[0][0], 12);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/system/unknowns.hpp"

#include <gtest/gtest.h>

namespace sundrape {
namespace {

TEST(Unknowns, LeaveOutHeldPointsAndKeepPartlyHeldOnes) {
  const Unknowns unknowns({{true, true, true}, {false, true, false}, {false, false, false}});
  EXPECT_EQ(unknowns.points(), 3);
  EXPECT_EQ(unknowns.rows(), 2);
  EXPECT_EQ(unknowns.row_of_point(), (std::vector<int>{-1, 0, 1}));
  ASSERT_EQ(unknowns.held_components().size(), 1U);
  EXPECT_EQ(unknowns.held_components()[0].row, 0);
  EXPECT_EQ(unknowns.held_components()[0].component, 1);

  const Vector all = Vector::LinSpaced(9, 0, 8);
  Vector rows(6), back = Vector::Constant(9, -1);
  unknowns.gather(all, rows);
  EXPECT_EQ(rows, Vector(all.tail(6)));
  unknowns.scatter(rows, back);
  EXPECT_EQ(back.tail(6), all.tail(6));
  EXPECT_EQ(back.head(3), Vector::Constant(3, -1));  // held points keep what stands there
  unknowns.clear_held(rows);
  EXPECT_EQ(rows[1], 0);
}

TEST(Unknowns, AreHeldUntilNoSupportHoldsThem) {
  Unknowns unknowns({{true, true, true}, {false, true, false}});
  for (int c = 0; c < 3; ++c) unknowns.hold(1, c);
  EXPECT_TRUE(unknowns.is_held(1));
  EXPECT_EQ(unknowns.held_components().size(), 3U);
  EXPECT_EQ(unknowns.rows(), 1);  // it stays
  for (int c = 0; c < 3; ++c) unknowns.let_go(1, c);
  EXPECT_FALSE(unknowns.is_held(1, 0));
  EXPECT_TRUE(unknowns.is_held(1, 1));  // by the support that it began with
  EXPECT_EQ(unknowns.held_components().size(), 1U);
  EXPECT_THROW(unknowns.let_go(1, 0), std::invalid_argument);
  EXPECT_THROW(unknowns.hold(0, 0), std::invalid_argument);
  EXPECT_THROW(unknowns.let_go(0, 0), std::invalid_argument);
}

TEST(Unknowns, SumProductsOverWhatIsHeld) {
  const Unknowns unknowns({{true, true, true}, {false, true, false}});
  Vector a(6), b(6);
  a << 1, 2, 3, 4, 5, 6;
  b << 1, 1, 1, 1, 10, 1;
  EXPECT_EQ(unknowns.held_dot(a, b), 56);
}

}  // namespace
}  // namespace sundrape

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

}  // namespace
}  // namespace sundrape

#include "sundrape/force/load_course.hpp"

#include <gtest/gtest.h>

namespace sundrape {
namespace {

double share(const LoadCourse& course, double time, int stage = 0) {
  const Vector nothing;
  return course.share({time, nothing, nothing, stage});
}

TEST(LoadCourse, RisesSmoothlyFromZeroToOneOverTime) {
  const LoadCourse course{.rise = 2.0};
  EXPECT_EQ(share(course, -1), 0);
  EXPECT_EQ(share(course, 0), 0);
  EXPECT_NEAR(share(course, 1), 0.5, 1e-15);
  EXPECT_EQ(share(course, 2), 1);
  EXPECT_EQ(share({}, 0), 1);
  EXPECT_NEAR(share(course, 1e-3), 10 * 1.25e-10, 1e-12);  // starts with the third power
}

TEST(LoadCourse, IsProportionalToTheLoadFactorWithinAStageAlsoBeyondItsEnds) {
  const LoadCourse course{.stages = {0, 1, -1}};
  EXPECT_EQ(share(course, 0.7, 1), 0);
  EXPECT_EQ(share(course, 0.25, 2), 0.25);
  EXPECT_EQ(share(course, -0.5, 2), -0.5);
  EXPECT_EQ(share(course, 1.5, 2), 1.5);
  EXPECT_EQ(share(course, 0.25, 3), 0.5);
  EXPECT_EQ(share(course, 0.25, 4), -1);  // it stays as the last stage left it
}

TEST(LoadCourse, OverTimeActsWithItsLastShare) {
  EXPECT_EQ(share({.stages = {0, 0.5}}, 3), 0.5);
  EXPECT_EQ(share({.rise = 1, .stages = {0, 0.5}}, 3), 0.5);
}

}  // namespace
}  // namespace sundrape

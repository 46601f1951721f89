#include "sundrape/force/path_course.hpp"

#include <gtest/gtest.h>

namespace sundrape {
namespace {

double share(const PathTiming& timing, double time) { return timing.share({time, Vector(), Vector()}); }
double rate(const PathTiming& timing, double time) { return timing.share_rate({time, Vector(), Vector()}); }

TEST(PathTiming, StartsAndStopsWhereItSays) {
  for (const auto profile : {PathTiming::Profile::smooth, PathTiming::Profile::linear}) {
    const PathTiming timing{.start = 1, .duration = 2, .profile = profile};
    EXPECT_EQ(share(timing, 0.5), 0);
    EXPECT_EQ(share(timing, 1), 0);
    EXPECT_DOUBLE_EQ(share(timing, 2), 0.5);
    EXPECT_EQ(share(timing, 3), 1);
    EXPECT_EQ(share(timing, 9), 1);
    EXPECT_EQ(timing.end(), 3);
  }
}

TEST(PathTiming, RateIsTheDerivativeOfTheShare) {
  for (const auto profile : {PathTiming::Profile::smooth, PathTiming::Profile::linear}) {
    const PathTiming timing{.start = 1, .duration = 2, .profile = profile};
    for (const double time : {0.5, 1.1, 1.7, 2.9, 3.5}) {
      const double h = 1e-6;
      EXPECT_NEAR(rate(timing, time), (share(timing, time + h) - share(timing, time - h)) / (2 * h), 1e-9) << time;
    }
  }
}

TEST(PathTiming, WithoutDurationItIsOver) { EXPECT_EQ(share({}, 0), 1); }

TEST(PathCourse, MovesWhatItCarries) {
  const PathCourse course{LinePath{{0, 0, 4}}, {.duration = 2, .profile = PathTiming::Profile::linear}};
  const State half{1, Vector(), Vector()};
  EXPECT_EQ(course.placement(half)({1, 2, 3}), Vector3(1, 2, 5));
  EXPECT_EQ(course.rate(half)({1, 2, 5}), Vector3(0, 0, 2));
}

}  // namespace
}  // namespace sundrape

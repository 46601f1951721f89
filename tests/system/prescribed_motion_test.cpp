#include "sundrape/system/prescribed_motion.hpp"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sundrape {
namespace {

constexpr double pi = std::numbers::pi;

PathCourse quarter_turn(double start, double duration) {
  return {ArcPath{.centre = {1, 0, 0}, .axis = Vector3::UnitZ(), .angle = pi / 2},
          {.start = start, .duration = duration, .profile = PathTiming::Profile::linear}};
}
PathCourse lift(double start, double duration) { return {LinePath{{0, 0, 2}}, {.start = start, .duration = duration}}; }

/// Point 0 is turned, then lifted; point 1 is lifted in z alone; point 2 is a direction that turns; point 3 is free.
PrescribedMotions motions() {
  return {{{.points = {0}, .course = quarter_turn(0, 1), .directions = {2}},
           {.points = {0, 1}, .components = {false, false, true}, .course = lift(0.5, 1)}},
          4};
}

Vector rest() {
  Vector q(12);
  q << 2, 0, 0, 5, 6, 7, 1, 0, 0, 8, 9, 10;
  return q;
}

TEST(PrescribedMotions, CarryPointsAlongOnePathAfterTheOther) {
  Vector q = rest();
  motions().place(1.5, 0, rest(), q);  // both paths are over
  Vector expected = rest();
  expected.head<3>() = Vector3(1, 1, 2);
  expected[5] = 9;
  expected.segment<3>(6) = Vector3(0, 1, 0);  // a direction is not lifted
  EXPECT_LT((q - expected).norm(), 1e-14);
}

TEST(PrescribedMotions, StayWhereTheyBeginAndEnd) {
  for (const double time : {-1.0, 0.0}) {
    Vector q = rest(), v = Vector::Ones(12);
    motions().place(time, rest(), q, v);
    EXPECT_LT((q - rest()).norm(), 1e-14);
  }
  Vector q = rest(), v = Vector::Constant(12, 3.0);
  motions().place(7, rest(), q, v);
  EXPECT_EQ(v[0], 0);
  EXPECT_EQ(v[5], 0);
  EXPECT_EQ(v[9], 3);  // not carried: as it was
}

TEST(PrescribedMotions, HaveTheRatesAndAccelerationsOfTheirPlaces) {
  const auto m = motions();
  constexpr double h = 1e-6;
  for (const double time : {0.2, 0.7, 0.9, 1.2}) {
    Vector q = rest(), v = Vector::Zero(12), after = rest(), before = rest();
    m.place(time, rest(), q, v);
    m.place(time + h, 0, rest(), after);
    m.place(time - h, 0, rest(), before);
    EXPECT_LT((v - (after - before) / (2 * h)).norm(), 1e-8) << time;
  }
  // uniform turning: the centripetal acceleration, ω² r = (π/2)² of point 0
  const Vector a = m.acceleration(0.25, rest());
  Vector q = rest();
  m.place(0.25, 0, rest(), q);
  const Vector3 inwards = Vector3(1, 0, 0) - Vector3(q.head<3>());
  EXPECT_LT((Vector3(a.head<3>()) - pi * pi / 4 * inwards).norm(), 1e-6);
  EXPECT_EQ(a.tail<3>().norm(), 0);
}

TEST(PrescribedMotions, GoByStagesInStagedStatics) {
  auto course = lift(3, 5);
  course.timing.stages = {0, 1};
  const PrescribedMotions m({{.points = {0}, .course = course}}, 4);
  Vector q = rest();
  m.place(1, 1, rest(), q);
  EXPECT_EQ(q[2], 0);  // begins when the first stage is over
  m.place(0.25, 2, rest(), q);
  EXPECT_DOUBLE_EQ(q[2], 0.5);
}

TEST(PrescribedMotions, TakeOtherPointsFromWhereTheyAre) {
  auto m = motions();
  Vector base = rest(), now = rest();
  m.place(0.8, 0, base, now);
  now.segment<3>(9) = Vector3(0.3, 0.4, 0.5);  // the free point has moved
  m.carry_instead(1, {0, 3}, {}, 0.8, now, base);
  Vector q = now;
  m.place(0.8, 0, base, q);
  EXPECT_LT((q - now).norm(), 1e-14);  // nothing jumps: not the new point, nor the one that two motions carry
  m.place(1.5, 0, base, q);
  const PathCourse up = lift(0.5, 1);
  const Vector still;
  const double rest_of_the_way = 2 - up.placement({0.8, still, still}).translation.z();
  EXPECT_NEAR(q[11], 0.5 + rest_of_the_way, 1e-14);
  EXPECT_NEAR(q[2], now[2] + rest_of_the_way, 1e-14);
  EXPECT_EQ(q[5], now[5]);  // let go
}

}  // namespace
}  // namespace sundrape

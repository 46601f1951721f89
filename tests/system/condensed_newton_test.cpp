#include "sundrape/system/condensed_newton.hpp"

#include <gtest/gtest.h>

#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

// c Δq − Δv = r_q,  c M Δv + K Δq + C Δv = r_v, checked against forces differenced along the solution.
TEST(CondensedNewton, SolvesTheFullSystemWithDamping) {
  const double relaxation_time = 1e-2, c = 300;
  const auto system = mass_on_spring(0, relaxation_time);
  CondensedNewton newton(system, make_linear_solver(SolverKind::lu), 1e-12);
  const Vector q = below(0.02).tail(3), v = Vector3(0, 0, 0.1);
  ASSERT_EQ(newton.prepare(0, c, q, v), FactorStatus::ok);
  const Vector r_q = Vector3(0.01, -0.02, 0.03), r_v = Vector3(0.1, 0.2, -0.3);
  Vector dq(3), dv(3);
  ASSERT_TRUE(newton.solve(r_q, r_v, dq, dv).ok);
  EXPECT_LE((c * dq - dv - r_q).norm(), 1e-12);
  const auto force = [&](double step) {
    Vector all_q = below(0.02), all_v = Vector::Zero(6), f(6);
    all_q.tail(3) = q + step * dq;
    all_v.tail(3) = v + step * dv;
    system.force({0, all_q, all_v}, f);
    return Vector(f.tail(3));
  };
  const Vector change = (force(1e-3) - force(-1e-3)) / 2e-3;  // −K Δq − C Δv
  EXPECT_LE((c * hanging_mass * dv - change - r_v).norm(), 1e-6 * r_v.norm());
  EXPECT_EQ(newton.counters().solves, 1);
}

TEST(CondensedNewton, LaterRightSidesOfAStepMakeDoWithFewerIterations) {
  const auto system = mass_on_spring(9.8);
  CondensedNewton newton(system, make_linear_solver(SolverKind::conjugate_gradients), 1e-6);
  const Vector q = below(0.02).tail(3), v = Vector::Zero(3), none = Vector::Zero(3);
  ASSERT_EQ(newton.prepare(0, 100, q, v), FactorStatus::ok);
  const Vector r = Vector3(0.1, 0.2, -0.3);
  Vector dq(3), dv(3);
  ASSERT_TRUE(newton.solve(none, r, dq, dv).ok);
  const Vector small = 1e-9 * r;
  ASSERT_TRUE(newton.solve(none, small, dq, dv).ok);
  EXPECT_LE(dq.norm(), 1e-6 * r.norm());
}

}  // namespace
}  // namespace sundrape

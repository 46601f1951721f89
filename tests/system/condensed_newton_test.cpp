#include "sundrape/system/condensed_newton.hpp"

#include <memory>
#include <string_view>
#include <vector>

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

/// Solves nothing, and keeps the tolerances that it is asked for.
class RecordingSolver final : public LinearSolver {
 public:
  explicit RecordingSolver(std::vector<double>& tolerances) : tolerances_(tolerances) {}
  [[nodiscard]] std::string_view name() const override { return "recorder"; }
  [[nodiscard]] Symmetry symmetry() const override { return Symmetry::symmetric; }
  void analyse(const BlockStructure& /*structure*/) override {}
  [[nodiscard]] FactorStatus factor(const BlockMatrix& /*matrix*/) override { return FactorStatus::ok; }
  [[nodiscard]] SolveReport solve(ConstVectorRef /*b*/, VectorRef x, double tolerance, double /*largest*/) override {
    tolerances_.push_back(tolerance);
    x.setZero();
    return {};
  }

 private:
  std::vector<double>& tolerances_;
};

TEST(CondensedNewton, LaterRightSidesOfAStepAreSolvedToTheDigitsOfItsFirst) {
  const auto system = mass_on_spring(9.8);
  std::vector<double> tolerances;
  CondensedNewton newton(system, std::make_unique<RecordingSolver>(tolerances), 1e-3);
  const auto prepare = [&](double time, double c) {
    ASSERT_EQ(newton.prepare(time, c, below(0.02).tail(3), Vector3::Zero()), FactorStatus::ok);
  };
  const Vector none = Vector3::Zero(), r = Vector3(0.1, 0.2, -0.3);
  // the tolerance for a right side of this part of r
  const auto tolerance = [&](double part) {
    Vector dq(3), dv(3);
    EXPECT_TRUE(newton.solve(none, part * r, dq, dv).ok);
    return tolerances.back();
  };

  prepare(0, 100);
  EXPECT_EQ(tolerance(1), 1e-3) << "the one asked for, at first";
  EXPECT_NEAR(tolerance(0.5), 2e-3, 1e-12) << "later by how much less there is to solve";
  EXPECT_NEAR(tolerance(-0.02), 5e-2, 1e-12);
  EXPECT_EQ(tolerance(1e-3), 0.1) << "but never looser than this";
  EXPECT_EQ(tolerance(7), 1e-3) << "nor stricter than asked";
  EXPECT_EQ(tolerance(0), 1e-3);

  prepare(0, 100);  // in the same step
  EXPECT_NEAR(tolerance(0.5), 2e-3, 1e-12);
  prepare(0, 120);  // another step, by its size
  EXPECT_EQ(tolerance(0.5), 1e-3);
  EXPECT_NEAR(tolerance(0.25), 2e-3, 1e-12);
  prepare(0.01, 120);  // another, by its time
  EXPECT_EQ(tolerance(0.25), 1e-3);
  EXPECT_NEAR(tolerance(0.125), 2e-3, 1e-12);
  EXPECT_EQ(tolerances.size(), 11U) << "one solve each";
}

}  // namespace
}  // namespace sundrape

#include "sundrape/statics/equilibrium_path.hpp"

#include <gtest/gtest.h>

#include "support/truss.hpp"

namespace sundrape {
namespace {

using samples::Truss;

struct Trace final : PathObserver {
  std::vector<PathPosition> steps;
  std::vector<PathStep> reports;
  std::vector<CriticalPoint> critical;
  std::vector<std::string> remarks, warnings;
  int iterations = 0, stop_after = -1;

  void step(const PathPosition& at, const PathStep& step) override {
    steps.push_back(at);
    reports.push_back(step);
  }
  void iteration(const PathPosition&, int, double, double) override { ++iterations; }
  void critical_point(const CriticalPoint& point) override { critical.push_back(point); }
  void remark(const std::string& text) override { remarks.push_back(text); }
  void warn(const std::string& text) override { warnings.push_back(text); }
  bool wants_to_stop() override { return static_cast<int>(steps.size()) == stop_after; }
};

// The joint of the truss may not leave its line: one unknown, and the two exact limit points of the closed form.
PathOptions truss_options(const Truss& truss) {
  PathOptions o;
  o.size = truss.half_span;
  o.first_increment = {0.05};
  o.largest_move = truss.rise / 10;
  o.tolerance = 1e-10;
  o.neutral_frequency = 1e-6;
  return o;
}

TEST(EquilibriumPath, TracesATrussThroughBothLimitPoints) {
  const Truss truss;
  const auto system = truss.system();
  PathPosition at{.q = truss.start()};
  Trace trace;
  const auto result = follow_path(system, truss_options(truss), at, trace);
  EXPECT_EQ(result.end, PathEnd::complete) << result.diagnosis;
  EXPECT_EQ(at.load_factor, 1);
  for (const auto& step : trace.steps)
    EXPECT_NEAR(step.load_factor * truss.full_load, truss.load(step.q[8]), 1e-9 * truss.full_load);
  ASSERT_EQ(trace.critical.size(), 2U);
  const double limit = truss.load(truss.limit_height()) / truss.full_load;
  EXPECT_NEAR(trace.critical[0].load_factor, limit, 2e-4 * limit);
  EXPECT_NEAR(trace.critical[1].load_factor, -limit, 2e-4 * limit);
  for (const auto& point : trace.critical) {
    EXPECT_EQ(point.kind, CriticalPoint::Kind::limit_point);
    EXPECT_NEAR(std::abs(point.q[8]), truss.limit_height(), 0.01 * truss.rise);
    EXPECT_NEAR(std::abs(point.mode[8]), 1, 1e-12);
  }
}

TEST(EquilibriumPath, PassesThemAgainOnTheWayBack) {
  const Truss truss;
  const auto system = truss.system({1, -1});
  auto options = truss_options(truss);
  options.stages = 2;
  PathPosition at{.q = truss.start()};
  Trace trace;
  ASSERT_EQ(follow_path(system, options, at, trace).end, PathEnd::complete);
  EXPECT_EQ(trace.critical.size(), 4U);
  EXPECT_NEAR(truss.load(at.q[8]), -truss.full_load, 1e-9);
  EXPECT_GT(at.q[8], truss.rise);  // above where it began: pulled up
}

TEST(EquilibriumPath, LoadStepsSnapToTheOnlyEquilibriumBeyondTheLimitPoint) {
  const Truss truss;
  const auto system = truss.system();
  auto options = truss_options(truss);
  options.control = PathControl::load;
  options.largest_move = 0;
  PathPosition at{.q = truss.start()};
  Trace trace;
  const auto result = follow_path(system, options, at, trace);
  ASSERT_EQ(result.end, PathEnd::complete) << result.diagnosis;
  for (std::size_t k = 1; k < trace.steps.size(); ++k)
    EXPECT_GT(trace.steps[k].load_factor, trace.steps[k - 1].load_factor);
  EXPECT_NEAR(truss.load(at.q[8]), truss.full_load, 1e-9);
  EXPECT_LT(at.q[8], -truss.rise);
  ASSERT_EQ(trace.warnings.size(), 1U);  // of the snap
  EXPECT_NE(trace.warnings[0].find("may have left the path"), std::string::npos) << trace.warnings[0];
}

TEST(EquilibriumPath, LoadStepsGoTowardsMoreLoadInEveryStage) {
  const Truss truss;
  const auto system = truss.system({1, -1});
  auto options = truss_options(truss);
  options.control = PathControl::load;
  options.largest_move = 0;
  options.stages = 2;
  PathPosition at{.q = truss.start()};
  Trace trace;
  const auto result = follow_path(system, options, at, trace);
  ASSERT_EQ(result.end, PathEnd::complete) << result.diagnosis;
  EXPECT_NEAR(truss.load(at.q[8]), -truss.full_load, 1e-9);
  EXPECT_GT(at.q[8], truss.rise);
  EXPECT_FALSE(trace.warnings.empty());
}

// Two bars in line, and a load across them: for small motions nothing resists it.
TEST(EquilibriumPath, SaysThatNothingResistsTheLoad) {
  const Truss flat{.rise = 0};
  const auto system = flat.system();
  auto options = truss_options(flat);
  options.largest_move = 0;
  PathPosition at{.q = flat.start()};
  Trace trace;
  auto result = follow_path(system, options, at, trace);
  EXPECT_EQ(result.end, PathEnd::stalled);
  EXPECT_NE(result.diagnosis.find("nothing resists"), std::string::npos) << result.diagnosis;
  EXPECT_EQ(at.load_factor, 0);

  options.fall = true;
  options.relaxation.tolerance = 1e-10;
  options.tolerance = 1e-8;
  at = {.q = flat.start()};
  result = follow_path(system, options, at, trace);
  ASSERT_EQ(result.end, PathEnd::complete) << result.diagnosis;
  EXPECT_NEAR(flat.load(at.q[8]), flat.full_load, options.tolerance * flat.full_load);
}

TEST(EquilibriumPath, WhereItMayFallTheTrussSnapsUnderTheLoadThatItCannotBear) {
  const Truss truss;
  const auto system = truss.system();
  auto options = truss_options(truss);
  options.fall = true;
  options.push = 1e-3 * truss.rise;
  options.relaxation.tolerance = 1e-10;
  PathPosition at{.q = truss.start()};
  Trace trace;
  const auto result = follow_path(system, options, at, trace);
  ASSERT_EQ(result.end, PathEnd::complete) << result.diagnosis;
  const double limit = truss.load(truss.limit_height()) / truss.full_load;
  double before = 0;
  for (const auto& step : trace.steps) {
    EXPECT_GE(step.load_factor, before);
    EXPECT_NEAR(step.load_factor * truss.full_load, truss.load(step.q[8]), 1e-8 * truss.full_load);
    if (step.q[8] > 0) {
      EXPECT_LE(step.load_factor, limit * (1 + 1e-6));
    }
    before = step.load_factor;
  }
  EXPECT_LT(at.q[8], -truss.rise);
  EXPECT_EQ(trace.reports.back().negative_pivots, 0);
  EXPECT_FALSE(trace.remarks.empty());
}

TEST(EquilibriumPath, StepsWithoutAccelerationStayAsLongAsTheFirst) {
  const Truss truss{.full_load = 0.02};  // below its limit
  const auto system = truss.system();
  auto options = truss_options(truss);
  options.accelerate = false;
  options.first_increment = {0.01};
  PathPosition at{.q = truss.start()};
  Trace slow, fast;
  ASSERT_EQ(follow_path(system, options, at, slow).end, PathEnd::complete);
  for (std::size_t k = 0; k + 1 < slow.reports.size(); ++k)
    EXPECT_NEAR(slow.steps[k].arc_length, slow.steps[0].arc_length, 1e-12);
  options.accelerate = true;
  at = {.q = truss.start()};
  ASSERT_EQ(follow_path(system, options, at, fast).end, PathEnd::complete);
  EXPECT_LT(5 * fast.steps.size(), slow.steps.size());
  EXPECT_NEAR(fast.steps.back().q[8], slow.steps.back().q[8], 1e-9 * truss.rise);
}

TEST(EquilibriumPath, AJointCarriedDownReactsWithTheTrussesLoad) {
  // prescribed displacement as what is controlled: the joint is held on a line and moved by 2 h
  const Truss truss{.full_load = 0};
  const PrescribedMotion down{{2}, {false, false, true}, LinePath{{0, 0, -2 * truss.rise}}, {}};
  // free in x (where symmetry keeps it), carried in z
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(
      std::make_unique<StretchSprings>(std::vector<StretchSpring>{{0, 2, truss.rest_length(), truss.stiffness},
                                                                  {1, 2, truss.rest_length(), truss.stiffness}},
                                       EnergyKind::membrane));
  const System carried(Vector::Ones(3), std::move(terms),
                       Unknowns({{true, true, true}, {true, true, true}, {false, true, true}}), truss.start(), {down});
  auto options = truss_options(truss);
  options.first_increment = {0.1};
  options.force_scale = 1;
  PathPosition at{.q = truss.start()};
  Trace trace;
  const auto result = follow_path(carried, options, at, trace);
  ASSERT_EQ(result.end, PathEnd::complete) << result.diagnosis;
  for (const auto& step : trace.steps) {
    EXPECT_NEAR(step.q[8], truss.rise * (1 - 2 * step.load_factor), 1e-15);
    Vector f(9);
    carried.force({step.load_factor, step.q, Vector::Zero(9), 1}, f);
    EXPECT_NEAR(f[8], truss.load(step.q[8]), 1e-12);
  }
}

TEST(EquilibriumPath, AThrustAlongABarForksWhereItsSpringLetsGo) {
  // A mass on a line above a spring of stiffness k, held sideways by one of stiffness c: pressed down by P it falls
  // over where P = c l, l the length left: the bar's force P over its length against c.
  constexpr double k = 1000, c = 2, length = 0.1, full = 0.3;
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(
      std::make_unique<StretchSprings>(std::vector<StretchSpring>{{0, 1, length, k}}, EnergyKind::membrane));
  constexpr double far = 1e4;  // a spring so long that it does not turn
  terms.push_back(std::make_unique<StretchSprings>(std::vector<StretchSpring>{{2, 1, far, c}}, EnergyKind::membrane));
  Vector force = Vector::Zero(9);
  force[5] = -full;
  terms.push_back(std::make_unique<DeadLoad>("force", EnergyKind::load, force));
  Vector start = Vector::Zero(9);
  start[5] = length;
  start[6] = -far;
  start[8] = length;
  const System system(Vector::Ones(3), std::move(terms),
                      Unknowns({{true, true, true}, {false, true, false}, {true, true, true}}), start);
  PathOptions options;
  options.size = length;
  options.first_increment = {0.1};
  options.tolerance = 1e-10;
  options.neutral_frequency = 1e-6;
  PathPosition at{.q = start};
  Trace trace;
  ASSERT_EQ(follow_path(system, options, at, trace).end, PathEnd::complete);
  ASSERT_EQ(trace.critical.size(), 1U);
  EXPECT_EQ(trace.critical[0].kind, CriticalPoint::Kind::bifurcation);
  const double critical = c * length / (1 + c / k);  // P = c l with l = length − P/k
  EXPECT_NEAR(trace.critical[0].load_factor * full, critical, 2e-4 * critical);
  EXPECT_NEAR(std::abs(trace.critical[0].mode[3]), 1, 1e-6);
  EXPECT_EQ(trace.reports.back().negative_pivots, 1);

  for (const double side : {1.0, -1.0}) {
    options.at_bifurcation = AtBifurcation::switch_branch;
    options.branch_amplitude = side * 1e-3 * length;
    at = {.q = start};
    Trace branch;
    options.max_steps = 12;
    (void)follow_path(system, options, at, branch);
    // leaning, the joint is in balance where P = c z (moments about the foot)
    int leaning = 0;
    for (const auto& step : branch.steps)
      if (step.q[3] * side * branch.critical[0].mode[3] > 1e-3 * length) {
        ++leaning;
        EXPECT_NEAR(step.load_factor * full, c * step.q[5], 1e-4 * full);  // the long spring turns a little
      }
    EXPECT_GE(leaning, 5);
  }
  options.at_bifurcation = AtBifurcation::stop;
  options.max_steps = 1000;
  at = {.q = start};
  Trace stopped;
  EXPECT_EQ(follow_path(system, options, at, stopped).end, PathEnd::at_bifurcation);
}

TEST(EquilibriumPath, StopsWhenItsObserverWantsToAndGoesOnFromThere) {
  const Truss truss;
  const auto system = truss.system();
  PathPosition whole{.q = truss.start()}, parts = whole;
  Trace all, first, second;
  ASSERT_EQ(follow_path(system, truss_options(truss), whole, all).end, PathEnd::complete);
  first.stop_after = 5;
  EXPECT_EQ(follow_path(system, truss_options(truss), parts, first).end, PathEnd::stopped);
  ASSERT_EQ(follow_path(system, truss_options(truss), parts, second).end, PathEnd::complete);
  EXPECT_EQ(first.steps.size() + second.steps.size(), all.steps.size());
  EXPECT_EQ(whole.q, parts.q);
}

TEST(EquilibriumPath, SaysWhereAndWhyItStalls) {
  const Truss truss;
  const auto system = truss.system();
  auto options = truss_options(truss);
  options.max_steps = 3;
  PathPosition at{.q = truss.start()};
  Trace trace;
  const auto result = follow_path(system, options, at, trace);
  EXPECT_EQ(result.end, PathEnd::stalled);
  EXPECT_NE(result.diagnosis.find("arc-length.max_steps"), std::string::npos) << result.diagnosis;
  EXPECT_NE(result.diagnosis.find("of stage 1, after 3 steps"), std::string::npos) << result.diagnosis;
}

}  // namespace
}  // namespace sundrape

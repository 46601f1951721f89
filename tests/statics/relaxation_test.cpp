#include "sundrape/statics/relaxation.hpp"

#include <gtest/gtest.h>

#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

struct Silent final : RelaxationObserver {
  int steps = 0, stop_after = -1;
  void step(const State&, const RelaxationStep&) override { ++steps; }
  bool wants_to_stop() override { return steps == stop_after; }
};

TEST(Relaxation, StretchesASpringByTheWeightOnIt) {
  const auto system = mass_on_spring(9.80665);
  const auto solver = make_linear_solver(SolverKind::cholesky);
  Vector q = below();
  Silent observer;
  const auto result = relax(system, *solver, {.tolerance = 1e-10}, q, observer);
  EXPECT_EQ(result.end, RelaxationEnd::converged) << result.diagnosis;
  EXPECT_NEAR(q[5], -spring_length - hanging_mass * 9.80665 / spring_stiffness,
              1e-10 * hanging_mass * 9.80665 / spring_stiffness);  // Hooke, to the residual asked for
  EXPECT_EQ(result.iterations, observer.steps);
  EXPECT_LE(relative_residual(system, {0, q, Vector::Zero(6)}, 0), 1e-10);
}

TEST(Relaxation, NoNodeMovesFurtherInAStepThanAllowed) {
  const auto system = mass_on_spring(9.80665);
  const auto solver = make_linear_solver(SolverKind::cholesky);
  struct Watch final : RelaxationObserver {
    double last = -spring_length, furthest = 0;
    void step(const State& all, const RelaxationStep&) override {
      furthest = std::max(furthest, std::abs(all.q[5] - last));
      last = all.q[5];
    }
    bool wants_to_stop() override { return false; }
  } watch;
  Vector q = below();
  EXPECT_EQ(relax(system, *solver, {.largest_move = 1e-3}, q, watch).end, RelaxationEnd::converged);
  EXPECT_LE(watch.furthest, 1e-3);
  EXPECT_GT(watch.furthest, 5e-4);  // and makes use of it
}

// A mass that is let go beside its spring's end swings down; long steps along the tangent stretch the spring.
TEST(Relaxation, TheEnergyRisesByNoMoreThanAllowed) {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(std::make_unique<StretchSprings>(
      std::vector<StretchSpring>{{0, 1, spring_length, 1e4 * spring_stiffness}}, EnergyKind::membrane, 0.0));
  const Vector mass = Vector::Constant(2, hanging_mass);
  terms.push_back(std::make_unique<DeadLoad>("gravity", EnergyKind::gravity, weight(mass, Vector3(0, 0, -9.80665))));
  const System system(mass, std::move(terms), Unknowns({{true, true, true}, {false, false, false}}), below());
  struct Watch final : RelaxationObserver {
    explicit Watch(const System& s, double start) : system(s), last(start) {}
    const System& system;
    double last, largest_rise = 0;
    void step(const State& all, const RelaxationStep&) override {
      const double energy = system.energies({0, all.q, Vector::Zero(6)}).stored();
      largest_rise = std::max(largest_rise, energy - last);
      last = energy;
    }
    bool wants_to_stop() override { return false; }
  };
  const auto rise_with_limit = [&](double limit) {
    const auto solver = make_linear_solver(SolverKind::cholesky);
    Vector q = Vector::Zero(6);
    q[3] = spring_length;
    Watch watch(system, system.energies({0, q, Vector::Zero(6)}).stored());
    EXPECT_EQ(relax(system, *solver, {.first_step = 0.05, .largest_rise = limit}, q, watch).end,
              RelaxationEnd::converged);
    return watch.largest_rise;
  };
  const double limit = 1e-3 * hanging_mass * 9.80665 * spring_length;
  EXPECT_GT(rise_with_limit(0), 10 * limit);
  EXPECT_LE(rise_with_limit(limit), limit);
}

TEST(Relaxation, SaysWhyAndWhereItStalls) {
  const auto system = mass_on_spring(9.80665);
  const auto solver = make_linear_solver(SolverKind::cholesky);
  Vector q = below();
  Silent observer;
  const auto result = relax(system, *solver, {.max_iterations = 2}, q, observer);
  EXPECT_EQ(result.end, RelaxationEnd::stalled);
  EXPECT_NE(result.diagnosis.find("node 1"), std::string::npos) << result.diagnosis;
  EXPECT_NE(result.diagnosis.find("relaxation.max_iterations"), std::string::npos) << result.diagnosis;
}

TEST(Relaxation, StopsWhenItsObserverWantsTo) {
  const auto system = mass_on_spring(9.80665);
  const auto solver = make_linear_solver(SolverKind::cholesky);
  Vector q = below();
  Silent observer;
  observer.stop_after = 3;
  const auto result = relax(system, *solver, {}, q, observer);
  EXPECT_EQ(result.end, RelaxationEnd::stopped);
  EXPECT_EQ(result.iterations, 3);
}

}  // namespace
}  // namespace sundrape

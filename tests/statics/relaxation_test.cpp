#include "sundrape/statics/relaxation.hpp"

#include <array>
#include <cmath>

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

/// A single point drawn to the origin along x by √|x|, of which Newton's method makes −x, −(−x) and so on.
class RootOfDistance final : public ForceTerm {
 public:
  [[nodiscard]] std::string_view name() const override { return "root"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::contact; }
  [[nodiscard]] double energy(const State& state) const override {
    return 2.0 / 3 * std::pow(std::abs(state.q[0]), 1.5);
  }
  void add_force(const State& state, VectorRef f) const override {
    f[0] -= std::copysign(std::sqrt(std::abs(state.q[0])), state.q[0]);
  }
  void add_tangent(const State& state, double dq, double /*dv*/, Assembler& tangent) const override {
    Matrix3 block = Matrix3::Zero();
    block(0, 0) = -dq * 0.5 / std::sqrt(std::abs(state.q[0]));
    tangent.add_diagonal(0, 0, block);
  }
  void declare_pattern(Pattern& pattern) const override {
    pattern.begin_term(1);
    pattern.add_element(std::array<int, 1>{0});
  }
};

TEST(Relaxation, DoesNotGoToAndFroForEver) {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(std::make_unique<RootOfDistance>());
  const System system(Vector::Ones(1), std::move(terms), Unknowns({{false, false, false}}), Vector::Zero(3));
  const auto solver = make_linear_solver(SolverKind::cholesky);
  struct Watch final : RelaxationObserver {
    std::vector<double> x;
    void step(const State& all, const RelaxationStep&) override { x.push_back(all.q[0]); }
    bool wants_to_stop() override { return false; }
  } watch;
  Vector q = Vector3(1, 0, 0);
  const auto result = relax(system, *solver, {.max_iterations = 500, .first_step = 1e4, .force_scale = 1}, q, watch);
  EXPECT_EQ(result.end, RelaxationEnd::converged) << result.diagnosis;
  ASSERT_GT(watch.x.size(), 50);
  EXPECT_NEAR(watch.x[49], 1, 1e-5);  // as plain Newton would for ever, but for the mass
  EXPECT_NEAR(q[0], 0, 1e-12);        // (10⁻⁶)²
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

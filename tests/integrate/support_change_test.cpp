#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sundrape/force/dead_load.hpp"
#include "sundrape/integrate/dynamics.hpp"

namespace sundrape {
namespace {

// A mass falls from rest, is gripped at 0.2 s, carried up at a constant speed and let go at 0.5 s. All of it in closed
// form: it falls g t²/2, then rises by u t, then flies as thrown with u.
constexpr double mass = 0.01, gravity = 9.80665, grip = 0.2, release = 0.5, speed = 0.8, end = 0.6;

System thrown() {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  Vector force = Vector::Zero(3);
  force[2] = -mass * gravity;
  terms.push_back(std::make_unique<DeadLoad>("gravity", EnergyKind::gravity, force));
  const PathCourse lift{LinePath{{0, 0, speed}},
                        {.start = grip, .duration = 1, .profile = PathTiming::Profile::linear}};
  return {Vector::Constant(1, mass),
          std::move(terms),
          Unknowns({Unknowns::Held{}}),
          Vector::Zero(3),
          {{.points = {}, .course = lift}}};
}

class Gripper final : public Timetable {
 public:
  explicit Gripper(System& system) : system_(system) {}
  [[nodiscard]] double next() const override {
    constexpr std::array times{grip, release, std::numeric_limits<double>::infinity()};
    return times.at(done_);
  }
  void happen(const State& all) override {
    if (done_++ == 0)
      system_.take_hold(0, {0}, {}, all);
    else
      system_.let_go(0, all);
  }

 private:
  System& system_;
  std::size_t done_ = 0;
};

class Frames final : public DynamicsObserver {
 public:
  void frame(const State& all, const EnergyAudit::Balance& balance) override {
    z.push_back(all.q[2]);
    books = balance;
  }
  void step(const State&, const StepReport&, const Integrator&) override {}
  [[nodiscard]] bool wants_to_stop() override { return false; }
  std::vector<double> z;
  EnergyAudit::Balance books;
};

std::unique_ptr<Integrator> make(const std::string& name, const System& system) {
  const IntegratorOptions options{.rtol = 1e-8, .atol_position = 1e-9, .atol_velocity = 1e-8, .max_order = 5};
  auto solver = make_linear_solver(SolverKind::cholesky);
  if (name == "cvode") return make_cvode(system, std::move(solver), options);
  if (name == "ida") return make_ida(system, std::move(solver), options);
  if (name == "dirk") return make_dirk(system, std::move(solver), options);
  return make_rk4(system, {.fixed_step = 1e-3});
}

class SupportChange : public testing::TestWithParam<std::string> {};

TEST_P(SupportChange, MassIsCaughtCarriedAndThrown) {
  auto system = thrown();
  const auto integrator = make(GetParam(), system);
  Gripper gripper(system);
  Frames frames;
  Dynamics dynamics(system, *integrator, {0.1, 0.35, release, end}, frames, nullptr, &gripper);
  (void)dynamics.run(0, Vector::Zero(3), Vector::Zero(3), true);
  constexpr double caught = -0.5 * gravity * grip * grip, let_go = caught + speed * (release - grip);
  constexpr double flight = end - release, landed = let_go + speed * flight - 0.5 * gravity * flight * flight;
  constexpr double tolerance = 1e-6;  // a hundred local errors of 1e-8
  ASSERT_EQ(frames.z.size(), 4U);
  EXPECT_NEAR(frames.z[0], -0.5 * gravity * 0.1 * 0.1, tolerance);
  EXPECT_NEAR(frames.z[1], caught + speed * (0.35 - grip), tolerance);
  EXPECT_NEAR(frames.z[2], let_go, tolerance);
  EXPECT_NEAR(frames.z[3], landed, tolerance);
  EXPECT_NEAR(dynamics.last().v[2], speed - gravity * flight, tolerance);

  // The catch takes the fall's kinetic energy m (g t)²/2 and gives that of the speed u instead; both are booked
  // together as what is lost. The lift puts in the weight's work.
  const double fall = 0.5 * mass * std::pow(gravity * grip, 2), carried = 0.5 * mass * speed * speed;
  EXPECT_NEAR(frames.books.dissipated, fall - carried, 1e-6 * fall);
  EXPECT_NEAR(frames.books.external_work, mass * gravity * (let_go - caught), 1e-6 * fall);
  EXPECT_NEAR(frames.books.method_dissipated, 0, 1e-5 * fall);
}

INSTANTIATE_TEST_SUITE_P(Integrators, SupportChange, testing::Values("cvode", "ida", "rk4", "dirk"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace sundrape

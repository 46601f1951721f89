#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/force/stretch_springs.hpp"
#include "sundrape/integrate/dynamics.hpp"

namespace sundrape {
namespace {

// A mass on a spring whose upper end, point 0 with a mass of its own, is lifted at constant speed u from t = 0 on: with
// ω² = k/m it lags by u sin(ωt)/ω, and the lift's force is m₀-free (no acceleration): k u sin(ωt)/ω.
constexpr double mass = 0.01, upper_mass = 0.02, stiffness = 4, length = 0.1, speed = 0.3, duration = 1;
const double frequency = std::sqrt(stiffness / mass);

System lifted(PathTiming::Profile profile) {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(
      std::make_unique<StretchSprings>(std::vector<StretchSpring>{{0, 1, length, stiffness}}, EnergyKind::membrane));
  Vector rest(6), masses(2);
  rest << 0, 0, 0, 0, 0, -length;
  masses << upper_mass, mass;
  const PathCourse lift{LinePath{{0, 0, speed * duration}}, {.duration = duration, .profile = profile}};
  return {masses,
          std::move(terms),
          Unknowns({Unknowns::Held{true, true, true}, Unknowns::Held{}}),
          rest,
          {{.points = {0}, .course = lift}}};
}

class Last final : public DynamicsObserver {
 public:
  void frame(const State& all, const EnergyAudit::Balance& balance) override {
    q = all.q;
    v = all.v;
    books = balance;
  }
  void step(const State&, const StepReport&, const Integrator&) override {}
  [[nodiscard]] bool wants_to_stop() override { return false; }
  Vector q, v;
  EnergyAudit::Balance books;
};

std::unique_ptr<Integrator> make(const std::string& name, const System& system) {
  const IntegratorOptions options{.rtol = 1e-7, .atol_position = 1e-9, .atol_velocity = 1e-7, .max_order = 5};
  auto solver = make_linear_solver(SolverKind::cholesky);
  if (name == "cvode") return make_cvode(system, std::move(solver), options);
  if (name == "ida") return make_ida(system, std::move(solver), options);
  if (name == "dirk") return make_dirk(system, std::move(solver), options);
  return make_rk4(system, {.fixed_step = 0.01 / frequency});
}

class CarriedSupport : public testing::TestWithParam<std::string> {};

TEST_P(CarriedSupport, DragsTheMassAlong) {
  const auto system = lifted(PathTiming::Profile::linear);
  const auto integrator = make(GetParam(), system);
  Last last;
  constexpr double end = 0.7;
  Dynamics dynamics(system, *integrator, {end}, last);
  Vector q(6);
  q << 0, 0, 0, 0, 0, -length;
  (void)dynamics.run(0, q, Vector::Zero(6), true);
  EXPECT_DOUBLE_EQ(last.q[2], speed * end);
  EXPECT_DOUBLE_EQ(last.v[2], speed);
  const double lag = speed / frequency * std::sin(frequency * end);
  EXPECT_NEAR(last.q[5], speed * end - lag - length, 1e-4 * speed / frequency);
}

TEST_P(CarriedSupport, PutsInTheWorkThatTheMotionHas) {
  const auto system = lifted(PathTiming::Profile::smooth);
  const auto integrator = make(GetParam(), system);
  Last last;
  Dynamics dynamics(system, *integrator, {0.5 * duration}, last);
  Vector q(6);
  q << 0, 0, 0, 0, 0, -length;
  (void)dynamics.run(0, q, Vector::Zero(6), true);
  // all of it is in the motion of both masses and the spring
  const double whole = last.books.energies.total();
  EXPECT_GT(whole, 0.5 * (mass + upper_mass) * speed * speed);  // it is at its fastest, 15/8 of the mean speed
  EXPECT_NEAR(last.books.external_work, whole, 2e-3 * whole);   // sums at the middles of steps
}

INSTANTIATE_TEST_SUITE_P(Of, CarriedSupport, testing::Values("cvode", "ida", "rk4", "dirk"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace sundrape

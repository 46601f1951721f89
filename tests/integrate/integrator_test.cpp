#include "sundrape/integrate/integrator.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/integrate/stability_limit.hpp"

#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

const double frequency = std::sqrt(spring_stiffness / hanging_mass);  // [1/s]

std::unique_ptr<Integrator> make(const std::string& name, const System& system) {
  const IntegratorOptions options{.rtol = 1e-8, .atol_position = 1e-10, .atol_velocity = 1e-8, .max_order = 5};
  auto solver = make_linear_solver(SolverKind::conjugate_gradients);
  if (name == "cvode") return make_cvode(system, std::move(solver), options);
  if (name == "ida") return make_ida(system, std::move(solver), options);
  if (name == "dirk") return make_dirk(system, std::move(solver), options);
  return make_rk4(system, {.fixed_step = 0.01 / frequency});
}

class Integrators : public testing::TestWithParam<std::string> {};

TEST_P(Integrators, FollowAnOscillator) {
  constexpr double amplitude = 0.01, end = 1;  // [m], [s]
  const auto system = mass_on_spring(0);
  const auto integrator = make(GetParam(), system);
  Vector q = below(amplitude).tail(3), v = Vector::Zero(3);
  integrator->start(0, q, v);
  double time = 0;
  while (time < end) time = integrator->step(end).time;
  integrator->state(q, v);
  EXPECT_NEAR(q[2], -spring_length - amplitude * std::cos(frequency * end), 1e-4 * amplitude);
  EXPECT_NEAR(v[2], amplitude * frequency * std::sin(frequency * end), 1e-4 * amplitude * frequency);
  EXPECT_GT(integrator->statistics().steps, 0);
  EXPECT_GT(integrator->statistics().force_evaluations, 0);
}

TEST_P(Integrators, InterpolateWithinTheLastStepAndRestart) {
  const auto system = mass_on_spring(0);
  const auto integrator = make(GetParam(), system);
  Vector q = below(0.01).tail(3), v = Vector::Zero(3);
  integrator->start(0, q, v);
  double time = 0, before = 0;
  while (time < 0.05) {
    before = time;
    time = integrator->step(1).time;
  }
  const double middle = 0.5 * (before + time);
  integrator->interpolate(middle, q, v);
  EXPECT_NEAR(q[2], -spring_length - 0.01 * std::cos(frequency * middle), 1e-5);
  const auto steps = integrator->statistics().steps;
  integrator->start(time, q, v);
  EXPECT_EQ(integrator->statistics().steps, steps);  // counters outlive a restart
  EXPECT_EQ(integrator->statistics().restarts, 1);
}

INSTANTIATE_TEST_SUITE_P(Of, Integrators, testing::Values("cvode", "ida", "rk4", "dirk"),
                         [](const auto& info) { return info.param; });

TEST(StabilityLimit, IsThatOfTheOnlyModeOfASpring) {
  const auto system = mass_on_spring(0);
  const auto limit = rk4_stability_limit(system, {0, below(), Vector::Zero(6)});
  EXPECT_NEAR(limit.angular_frequency, frequency, 1e-2 * frequency);
  EXPECT_NEAR(limit.step, 2 * std::sqrt(2.0) / frequency, 1e-2 / frequency * 3);
  EXPECT_EQ(limit.damping_rate, 0);
}

TEST(StabilityLimit, OfOneModeIsWhereTheAmplificationPassesOne) {
  EXPECT_NEAR(rk4_stable_step(1, 0), 2 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(rk4_stable_step(1e-9, 1), 2.785293563, 1e-6);  // real root of R(-z) = 1
}

}  // namespace
}  // namespace sundrape

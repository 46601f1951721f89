// The diagonally implicit Runge–Kutta methods by what their order, γ and number of stages alone say of them.
#include <array>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "sundrape/integrate/integrator.hpp"

#include "support/benchmarks.hpp"
#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

struct Method {
  int order, stages;
  double gamma;
};

// Hosea & Shampine 1996 (TR-BDF2: γ = 1 − ½√2); Kennedy & Carpenter 2016 and 2019 (ESDIRK3(2)5L[2]SA,
// ESDIRK4(3)6L[2]SA, ESDIRK5(4)7L[2]SA2)
const std::array methods{Method{2, 3, 1 - std::sqrt(0.5)}, Method{3, 5, 0.225}, Method{4, 6, 0.25},
                         Method{5, 7, 0.184}};

double binomial(int n, int k) { return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k; }

/// R(z) = P(z)/(1 − γ z)^(s−1) of an L-stable, stiffly accurate method whose first stage of s is explicit: P has degree
/// s − 2, for R(∞) = 0, and agrees with e^z (1 − γ z)^(s−1) up to the method's order, which here leaves nothing open.
std::complex<double> stability_function(const Method& m, std::complex<double> z) {
  const int n = m.stages - 1;
  EXPECT_GE(m.order, n - 1);
  std::complex<double> p = 0;
  for (int k = 0; k < n; ++k) {
    double coefficient = 0;
    for (int j = 0; j <= k; ++j) coefficient += binomial(n, j) * std::pow(-m.gamma, j) / std::tgamma(k - j + 1);
    p += coefficient * std::pow(z, k);
  }
  return p / std::pow(1.0 - m.gamma * z, n);
}

// Stages of too long a step are predicted tens of times further out, which is to remain a small part of the spring.
constexpr double amplitude = 1e-4;                                    // [m]
const double frequency = std::sqrt(spring_stiffness / hanging_mass);  // [1/s]

/// The mass on a spring after steps of one length, pulled down by `amplitude` and let go: its place about the spring's
/// free length and its speed over ω, as one complex number over the amplitude.
std::complex<double> swung(int order, double step, int steps, IntegratorStatistics* statistics = nullptr) {
  const auto system = mass_on_spring(0);
  const auto integrator = make_dirk(system, make_linear_solver(SolverKind::conjugate_gradients),
                                    {.rtol = 1e-12,
                                     .atol_position = 1e-13,
                                     .atol_velocity = 1e-13 * frequency,
                                     .max_order = order,
                                     .fixed_step = step,
                                     .linear_tolerance = 1e-13});
  Vector q = below(amplitude).tail(3), v = Vector::Zero(3);
  integrator->start(0, q, v);
  for (int n = 0; n < steps; ++n) EXPECT_NEAR(integrator->step(1e9).step_size, step, 1e-12 * step);
  integrator->state(q, v);
  if (statistics != nullptr) *statistics = integrator->statistics();
  return {(-spring_length - q[2]) / amplitude, v[2] / (amplitude * frequency)};
}

class Dirk : public testing::TestWithParam<Method> {};

// The spring stays straight, so the motion is linear: y' = iω y, and each step multiplies by R(iωh).
TEST_P(Dirk, MultipliesAnOscillationByItsStabilityFunction) {
  const auto& m = GetParam();
  constexpr int steps = 6;
  for (const double angle : {0.1, 0.7, 3.0, 20.0}) {
    // place + i speed/ω turns backwards in the convention y' = iω y
    const auto expected = std::pow(std::conj(stability_function(m, {0, angle})), steps);
    const auto found = std::conj(swung(m.order, angle / frequency, steps));
    EXPECT_LT(std::abs(found - expected), 1e-8) << "ωh = " << angle;
  }
}

TEST_P(Dirk, KillsWhatIsTooStiffToFollow) {
  const auto& m = GetParam();
  EXPECT_LT(std::abs(swung(m.order, 1e4 / frequency, 1)), 1e-2);
}

// Errors against e^{iωt} between two steps where the method's own error, not that of Newton's iteration, is left.
TEST_P(Dirk, ConvergesWithItsOrder) {
  const auto& m = GetParam();
  const auto error = [&](int steps) {
    const double turn = 4;  // ωt at the end
    return std::abs(swung(m.order, turn / steps / frequency, steps) - std::polar(1.0, turn));
  };
  EXPECT_NEAR(observed_order(error(20), error(40)), m.order, 0.2);
}

// The last stage's equation gives the rates that the next step begins with, so every step costs s − 1 solutions and no
// force evaluation but theirs: on a linear motion Newton's iteration needs two, the second to see that it is done.
TEST_P(Dirk, EvaluatesForcesForNewtonsIterationOnly) {
  IntegratorStatistics s;
  (void)swung(GetParam().order, 0.1 / frequency, 50, &s);
  EXPECT_EQ(s.steps, 50);
  EXPECT_EQ(s.step_solve_failures, 0);
  EXPECT_LE(s.force_evaluations, s.newton_iterations + 5);
}

// Cubic between the ends of a step: h⁴/384 of the largest fourth derivative, with h the step.
TEST_P(Dirk, InterpolatesToTheFourthOrder) {
  const auto system = mass_on_spring(0);
  const double h = 0.2 / frequency;
  const auto integrator = make_dirk(system, make_linear_solver(SolverKind::conjugate_gradients),
                                    {.rtol = 1e-12,
                                     .atol_position = 1e-13,
                                     .atol_velocity = 1e-13 * frequency,
                                     .max_order = GetParam().order,
                                     .fixed_step = h,
                                     .linear_tolerance = 1e-13});
  Vector q = below(amplitude).tail(3), v = Vector::Zero(3), before = q, after = q, rate = v, rate_after = v;
  integrator->start(0, q, v);
  (void)integrator->step(1);
  integrator->state(before, rate);
  (void)integrator->step(1);
  integrator->state(after, rate_after);
  // the exact motion through the step's beginning, for the cubic's error apart from the method's
  const double u0 = -spring_length - before[2], s0 = -rate[2] / frequency;
  const double u1 = -spring_length - after[2], s1 = -rate_after[2] / frequency;
  for (const double part : {0.25, 0.5, 0.75}) {
    integrator->interpolate((1 + part) * h, q, v);
    const double angle = frequency * part * h;
    const double exact = u0 * std::cos(angle) + s0 * std::sin(angle);
    const double method =
        std::hypot(u0 * std::cos(0.2) + s0 * std::sin(0.2) - u1, s0 * std::cos(0.2) - u0 * std::sin(0.2) - s1);
    EXPECT_LT(std::abs(-spring_length - q[2] - exact), 2 * method + amplitude * std::pow(0.2, 4) / 384) << part;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Dirk, testing::ValuesIn(methods),
                         [](const auto& info) { return "Order" + std::to_string(info.param.order); });

TEST(DirkMethods, AreOfOrderTwoToFive) {
  const auto system = mass_on_spring(0);
  for (const int order : {1, 6})
    EXPECT_THROW((void)make_dirk(system, make_linear_solver(SolverKind::conjugate_gradients), {.max_order = order}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

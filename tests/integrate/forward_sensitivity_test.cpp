#include "sundrape/integrate/forward_sensitivity.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/linalg/lu.hpp"

#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

System oscillator(double stiffness, double mass) {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(std::make_unique<StretchSprings>(std::vector<StretchSpring>{{0, 1, spring_length, stiffness}},
                                                   EnergyKind::membrane, 0.0));
  return {Vector::Constant(2, mass), std::move(terms), Unknowns({{true, true, true}, {false, false, false}}), below()};
}

class ForwardSensitivities : public testing::TestWithParam<BdfForm> {};

TEST_P(ForwardSensitivities, OfAnOscillatorAreThoseOfItsFrequency) {
  // x = −L − a cos ωt, ω² = k/m: k dx/dk = ½ a ωt sin ωt, m dx/dm = −½ a ωt sin ωt
  constexpr double amplitude = 0.01, e = ParameterDerivative::relative_change;
  const auto system = oscillator(spring_stiffness, hanging_mass);
  const auto stiffer = oscillator((1 + e) * spring_stiffness, hanging_mass),
             heavier = oscillator(spring_stiffness, (1 + e) * hanging_mass);
  ParameterDerivative by_stiffness(system, stiffer), by_mass(system, heavier);
  const IntegratorOptions options{.rtol = 1e-8, .atol_position = 1e-10, .atol_velocity = 1e-8, .max_order = 5};
  auto solver = make_linear_solver(SolverKind::cholesky);
  const auto integrator = GetParam() == BdfForm::ida ? make_ida(system, std::move(solver), options)
                                                     : make_cvode(system, std::move(solver), options);
  ForwardSensitivity sensitivity(system, std::make_unique<Lu>(), {&by_stiffness, &by_mass}, GetParam(), 5);
  const Vector nothing = Vector::Zero(6);
  sensitivity.set({nothing, nothing}, {nothing, nothing});
  Vector q = below(amplitude), v = nothing, rows_q = q.tail(3), rows_v = v.tail(3);
  integrator->start(0, rows_q, rows_v);
  sensitivity.restart(0);
  constexpr double end = 1;
  for (double time = 0; time < end;) {
    const auto report = integrator->step(end);
    time = report.time;
    integrator->state(rows_q, rows_v);
    q.tail(3) = rows_q;
    v.tail(3) = rows_v;
    sensitivity.step(report, {time, q, v});
  }
  const double turn = std::sqrt(spring_stiffness / hanging_mass) * end;
  const double expected = 0.5 * amplitude * turn * std::sin(turn);
  const double expected_rate = 0.5 * amplitude * turn / end * (std::sin(turn) + turn * std::cos(turn));
  Vector s(6), s_dot(6);
  for (const auto& [parameter, sign] : {std::pair(0U, 1), std::pair(1U, -1)}) {
    sensitivity.at(end, parameter, s, s_dot);
    EXPECT_NEAR(s[5], sign * expected, 1e-4 * amplitude * turn);
    EXPECT_NEAR(s_dot[5], sign * expected_rate, 1e-4 * std::abs(expected_rate));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ForwardSensitivities, testing::Values(BdfForm::cvode, BdfForm::ida),
                         [](const auto& info) { return info.param == BdfForm::ida ? "ida" : "cvode"; });

}  // namespace
}  // namespace sundrape

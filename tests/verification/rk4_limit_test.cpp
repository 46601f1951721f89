// The fixed-step Runge–Kutta method: stable below its reported limit and there as right as CVODE, lost above it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sundrape/integrate/stability_limit.hpp"

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

constexpr double size = 0.3;  // of the cloth [m]
const std::string undamped = "material.damping={ mass = 0, membrane = 0, bending = 0 }";
const std::string damped = "material.damping={ mass = 0, membrane = 1e-3, bending = 0.3e-3 }";

Benchmark cloth(int cells, const std::string& damping, std::vector<std::string> sets) {
  sets.push_back(fmt::format("cloth.cells=[{0},{0}]", cells));
  sets.push_back(damping);
  sets.emplace_back("output.frames=3");
  return benchmark("hanging_cloth.toml", sets);
}

double stable_step(int cells, const std::string& damping) {
  const auto b = cloth(cells, damping, {});
  return rk4_stability_limit(*b.model.system, {0, b.model.initial, Vector::Zero(b.model.initial.size())}).step;
}

Motion runge_kutta(int cells, const std::string& damping, double step) {
  return motion(
      cloth(cells, damping,
            {"dynamics.duration=0.15 s", "dynamics.integrator=rk4", fmt::format("dynamics.step={:.17g}", step)}));
}

/// What a step resolves, both methods follow to far better than this. What it does not are membrane modes, which the
/// cloth's weight stretches by w L/(E h) = 1.1e-3 at the most.
constexpr double tolerance = 1e-3;  // of the size

void expect_agreement(int cells, const std::string& damping) {
  const auto exact =
      motion(cloth(cells, damping, {"dynamics.duration=0.15 s", "dynamics.rtol=1e-7", "dynamics.max_order=2"}));
  const double step = 0.95 * stable_step(cells, damping);
  const auto m = runge_kutta(cells, damping, step);
  const double apart =
      (m.position.back() - exact.position.back()).reshaped(3, m.position.back().size() / 3).colwise().norm().maxCoeff();
  const double moved = (m.position.back() - m.position.front()).cwiseAbs().maxCoeff();
  fmt::print("{}² cells, step {:.3g} s: {:.2e} of the size from CVODE, having moved {:.2f} of it\n", cells, step,
             apart / size, moved / size);
  EXPECT_GT(moved, 0.1 * size);
  EXPECT_LT(apart, tolerance * size);
}

TEST(Rk4Limit, BelowItTheMotionIsThatOfCvode) { expect_agreement(4, undamped); }

TEST(Rk4Limit, HalvingTheStepLeavesASixteenthOfTheError) {
  const double step = stable_step(4, undamped);
  const auto end = [&](double share) { return runge_kutta(4, undamped, share * step).position.back(); };
  const Vector exact = end(1.0 / 32);
  EXPECT_GE(observed_order((end(1.0 / 4) - exact).norm(), (end(1.0 / 8) - exact).norm()), 3.8);
}

TEST(Rk4Limit, AboveItTheMotionBlowsUp) {
  EXPECT_THROW((void)runge_kutta(4, undamped, 1.1 * stable_step(4, undamped)), IntegrationFailure);
}

TEST(Rk4LimitVerification, HoldsWithAndWithoutDampingOnFinerNets) {
  for (const int cells : {6, 10})
    for (const auto& damping : {undamped, damped}) {
      expect_agreement(cells, damping);
      EXPECT_THROW((void)runge_kutta(cells, damping, 1.1 * stable_step(cells, damping)), IntegrationFailure)
          << cells << " cells, " << damping;
    }
}

}  // namespace
}  // namespace sundrape

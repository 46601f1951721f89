// B1: the tip-loaded cantilever (chapter §4.1) against the elastica and against the second-order chain.
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

constexpr double ei = 3.4641016151377544e-9;  // [N m²]; L = 1 m
constexpr double stretch = 1e-5;              // P/EA at λ = 10: the elastica does not stretch, the strip does

/// θ'' = −λ cos θ, θ(0) = 0, θ'(1) = 0 by central differences on n edges, θ at their middles: what a second-order
/// method makes of the elastica. Shooting from the root moment, by Newton's method along growing λ.
Tip second_order_chain(int n, double lambda) {
  const double b = 1.0 / n;
  std::vector<double> theta(static_cast<std::size_t>(n));
  const auto shoot = [&](double first, double load) {
    double angle = first, curvature = 2 * first / b, by_angle = 1, by_curvature = 2 / b;
    for (auto& t : theta) {
      t = angle;
      by_curvature += load * b * std::sin(angle) * by_angle;
      curvature -= load * b * std::cos(angle);
      by_angle += b * by_curvature;
      angle += b * curvature;
    }
    return std::pair(curvature, by_curvature);
  };
  double first = 0;
  constexpr int load_steps = 40;
  for (int k = 1; k <= load_steps; ++k)
    for (int i = 0; i < 20; ++i) {
      const auto [curvature, slope] = shoot(first, lambda * k / load_steps);
      first -= curvature / slope;
    }
  (void)shoot(first, lambda);
  Tip tip{1, 0, theta.back() + (theta.back() - theta[theta.size() - 2]) / 8};
  for (const double t : theta) {
    tip.shortening -= b * std::cos(t);
    tip.rise += b * std::sin(t);
  }
  return tip;
}

Tip net(int cells, double lambda, int& iterations) {
  const auto b = benchmark("cantilever_tip_force.toml",
                           {cells_along(cells), fmt::format("load.0.total=[0,0,{:.17g}]", lambda * ei)});
  const auto rest = equilibrium(b, 1e-7);
  iterations = rest.result.iterations;
  const auto line = centre_line(b.model.mesh, rest.q);
  const Vector3 tip = line.back() - line.front();
  return {1 - tip.x(), tip.z(), tip_rotation(line, 0)};
}

TEST(CantileverTipForce, EightCellsAreTheSecondOrderChain) {
  for (const auto& [lambda, exact] : elastica_of_tip_force()) {
    if (std::fmod(lambda, 2.5) != 0) continue;
    int iterations = 0;
    const Tip tip = net(8, lambda, iterations), chain = second_order_chain(8, lambda);
    EXPECT_LE(tip.distance(chain), 2 * stretch) << "λ = " << lambda;
    EXPECT_NEAR(tip.rotation, chain.rotation, 2 * stretch) << "λ = " << lambda;
  }
}

TEST(CantileverTipForceVerification, SecondOrderFromEightToSixtyFourCellsAtEveryLoad) {
  fmt::print("  λ     |tip error|/L at 8, 16, 32, 64 cells             rotation error [rad] at 8, 64   iterations\n");
  for (const auto& [lambda, exact] : elastica_of_tip_force()) {
    std::map<int, Tip> tips;
    std::map<int, double> errors;
    std::map<int, int> iterations;
    for (const int n : {8, 16, 32, 64}) {
      tips[n] = net(n, lambda, iterations[n]);
      errors[n] = tips[n].distance(exact);
    }
    fmt::print("{:5.1f}   {:.3e} {:.3e} {:.3e} {:.3e}   {:+.2e} {:+.2e}   {} {} {} {}\n", lambda, errors[8], errors[16],
               errors[32], errors[64], tips[8].rotation - exact.rotation, tips[64].rotation - exact.rotation,
               iterations[8], iterations[16], iterations[32], iterations[64]);
    // theory: C n⁻² with C from a chain fine enough to show nothing but its leading term; 1 % for the terms behind it
    const double leading = 512 * 512 * second_order_chain(512, lambda).distance(exact);
    EXPECT_LE(errors[8], 1.01 * leading / 64 + stretch) << "λ = " << lambda;
    for (const int n : {8, 16, 32}) EXPECT_GE(observed_order(errors[n], errors[2 * n]), 1.9) << "λ = " << lambda;
    EXPECT_LE(errors[64], 1e-3) << "λ = " << lambda;
    EXPECT_NEAR(tips[64].rotation, exact.rotation, 1e-3) << "λ = " << lambda;
  }
}

}  // namespace
}  // namespace sundrape

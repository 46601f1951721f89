// B1: the tip-loaded cantilever (chapter §4.1) of shell elements, against the elastica and the chain of directors.
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"
#include "support/director_chain.hpp"

namespace sundrape {
namespace {

constexpr double ei = 3.4641016151377544e-9;  // [N m²]; L = 1 m
constexpr double thinness = 1e-6;             // EI/(EA L²) = h²/12 L²
// What the strip has and the elastica has not, over L: stretch P/EA and transverse shear P/(κ G A), κ G A = 5/12 EA;
// and by the work of the moment on them, the strains M K/EA of the mid-surface and of the director, each of which
// counts twice in the curvature that a moment takes. K² ≤ 2 λ and the turn is less than 3/2.
double thickness_effect(double lambda) { return (1 + 12.0 / 5 + 4 * 2 * 1.5) * lambda * thinness; }

Tip shell(int elements, double lambda, int* iterations = nullptr) {
  const auto b = benchmark("cantilever_tip_force.toml", {"model=shell", cells_along(elements),
                                                         fmt::format("load.0.total=[0,0,{:.17g}]", lambda * ei)});
  const auto rest = equilibrium(b, 1e-7);
  if (iterations != nullptr) *iterations = rest.result.iterations;
  const auto line = centre_line(b.model.mesh, rest.q);
  const Vector3 tip = line.back() - line.front();
  return {1 - tip.x(), tip.z(), director_angles(b.model, rest.q).back()};
}

Tip chain(int elements, double lambda) {
  const auto shape = DirectorChain{.law = MomentCurvature::linear(1), .tip_force = lambda}.solve(elements);
  return {1 - shape.tip.x(), shape.tip.y(), shape.tip_angle};
}

TEST(ShellCantileverTipForce, EightElementsAreWithinOnePercentAndAreTheChainOfDirectors) {
  for (const auto& [lambda, exact] : elastica_of_tip_force()) {
    const Tip tip = shell(8, lambda), expected = chain(8, lambda);
    EXPECT_LE(tip.distance(exact), 0.01) << "λ = " << lambda;
    EXPECT_LE(tip.distance(expected), thickness_effect(lambda)) << "λ = " << lambda;
    EXPECT_NEAR(tip.rotation, expected.rotation, thickness_effect(lambda)) << "λ = " << lambda;
  }
}

TEST(ShellCantileverTipForceVerification, SecondOrderFromEightToThirtyTwoElementsAtEveryLoad) {
  fmt::print("  λ     |tip error|/L at 8, 16, 32 elements   orders       rotation error [rad] at 8, 32   iterations\n");
  for (const auto& [lambda, exact] : elastica_of_tip_force()) {
    std::map<int, Tip> tips;
    std::map<int, double> errors;
    std::map<int, int> iterations;
    for (const int n : {8, 16, 32}) {
      tips[n] = shell(n, lambda, &iterations[n]);
      errors[n] = tips[n].distance(exact);
      EXPECT_LE(tips[n].distance(chain(n, lambda)), thickness_effect(lambda)) << "λ = " << lambda;
    }
    const double first = observed_order(errors[8], errors[16]), second = observed_order(errors[16], errors[32]);
    fmt::print("{:5.1f}   {:.3e} {:.3e} {:.3e}   {:.3f} {:.3f}   {:+.2e} {:+.2e}   {} {} {}\n", lambda, errors[8],
               errors[16], errors[32], first, second, tips[8].rotation - exact.rotation,
               tips[32].rotation - exact.rotation, iterations[8], iterations[16], iterations[32]);
    EXPECT_GE(first, 1.9) << "λ = " << lambda;
    EXPECT_GE(second, 1.9) << "λ = " << lambda;
    EXPECT_LE(errors[32], 1e-3) << "λ = " << lambda;
  }
}

}  // namespace
}  // namespace sundrape

// B2: the moment-loaded cantilever (chapter §4.2) of shell elements, up to the closed circle, against its closed form.
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"
#include "support/director_chain.hpp"

namespace sundrape {
namespace {

using std::numbers::pi;
constexpr double ei = 3.4641016151377544e-9;  // [N m²]; L = 1 m
constexpr double thinness = 1e-6;             // EI/(EA L²) = h²/12 L²
constexpr double solved = 1e-5;               // what the relaxation's tolerance of 1e-8 leaves, generously
// What a strip has that the closed form has not: the moment works on mid-surface and director as well, which shorten by
// M K/EA = thinness K². Each counts in the curvature and so does its share in the work of M: twice in the turn, that of
// the director as often as the geodesic factor says, d ln K/d ln |t| = tan(Δ/2)/(Δ/2) for a turn Δ of an element.
double shortening(double lambda) { return thinness * std::pow(lambda * pi, 2); }
double turn(int elements, double lambda) {
  const double half = 0.5 * lambda * pi / elements, by_director = std::tan(half) / half;
  return lambda * pi * (1 + shortening(lambda) * (2 + 2 * by_director * by_director));
}
/// The closed form of a strip of that thickness.
Tip thick_strip(double lambda) {
  const double length = 1 - shortening(lambda), angle = lambda * pi * (1 + 4 * shortening(lambda));
  return {1 - length * std::sin(angle) / angle, length * (1 - std::cos(angle)) / angle, angle};
}
// The directors of the clamp and of the tip share theirs with half an element: up to as much less turn.
double extra_turn(int elements, double lambda) { return turn(elements, lambda) - lambda * pi; }

Tip shell(int elements, double lambda, const std::string& bending = "geodesic", int* iterations = nullptr,
          const std::vector<std::string>& more = {}) {
  std::vector<std::string> sets{"model=shell", "shell.bending=" + bending, cells_along(elements),
                                fmt::format("load.0.total=[0,{:.17g},0]", -lambda * pi * ei)};
  sets.insert(sets.end(), more.begin(), more.end());
  const auto b = benchmark("cantilever_tip_moment.toml", sets);
  const auto rest = equilibrium(b, 1e-8);
  if (iterations != nullptr) *iterations = rest.result.iterations;
  const auto line = centre_line(b.model.mesh, rest.q);
  const Vector3 tip = line.back() - line.front();
  return {1 - tip.x(), tip.z(), director_angles(b.model, rest.q).back()};
}

Tip chain(int elements, double lambda, bool chord = false) {
  const auto shape =
      DirectorChain{.law = MomentCurvature::linear(1), .tip_moment = lambda * pi, .chord = chord}.solve(elements);
  return {1 - shape.tip.x(), shape.tip.y(), shape.tip_angle};
}

TEST(ShellCantileverTipMoment, EightElementsAreWithinOnePercentUpToTheClosedCircle) {
  for (const auto& [lambda, exact] : arcs_of_tip_moment()) {
    const Tip tip = shell(8, lambda);
    EXPECT_LE(tip.distance(exact), 0.01) << "λ = " << lambda;
    const double bound = extra_turn(8, lambda) + shortening(lambda) + solved;  // a tip moves by no more than its turn
    EXPECT_LE(tip.distance(chain(8, lambda)), bound) << "λ = " << lambda;
    EXPECT_NEAR(tip.rotation, exact.rotation, extra_turn(8, lambda) + solved) << "λ = " << lambda;
  }
}

TEST(ShellCantileverTipMoment, AStripAsWideAsLongClosesItsCircleToo) {
  // the same E A and E I of a strip whose elements are eight times as wide as long, three times the circle's diameter:
  // without the lateral factor its directors would fan out
  const std::vector<std::string> wide{"cloth.size=[1, 1]", "material.youngs_modulus=1", "material.density_area=1e-8"};
  for (const auto& [lambda, exact] : arcs_of_tip_moment())
    EXPECT_LE(shell(8, lambda, "geodesic", nullptr, wide).distance(exact), 0.01) << "λ = " << lambda;
}

TEST(ShellCantileverTipMoment, CurvatureFromChordsTurnsTooFar) {
  // sin Δ = π λ/n: 15 % too far with eight elements of a circle, and its ends miss each other by 13 % of the length
  const Tip tip = shell(8, 2, "bilinear"), expected = chain(8, 2, true);
  EXPECT_NEAR(expected.rotation, 8 * std::asin(pi / 4), 1e-9);
  EXPECT_NEAR(tip.rotation, expected.rotation, 2 * extra_turn(8, 2));  // thickness counts 1/cos Δ = 1.6 times here
  EXPECT_NEAR(tip.distance({1, 0, 0}), 0.13, 0.005);
}

TEST(ShellCantileverTipMomentVerification, SecondOrderFromEightToThirtyTwoElementsUpToTheClosedCircle) {
  fmt::print("  λ     |tip error|/L at 8, 16, 32 elements   rotation error [rad] at 8, 32   iterations   of chords\n");
  for (const auto& [lambda, exact] : arcs_of_tip_moment()) {
    std::map<int, Tip> tips;
    std::map<int, double> errors, of_chords;
    std::map<int, int> iterations;
    for (const int n : {8, 16, 32}) {
      tips[n] = shell(n, lambda, "geodesic", &iterations[n]);
      errors[n] = tips[n].distance(exact);
      of_chords[n] = shell(n, lambda, "bilinear").distance(exact);
      const double bound = extra_turn(n, lambda) + shortening(lambda) + solved;
      EXPECT_LE(tips[n].distance(chain(n, lambda)), bound) << "λ = " << lambda;
      EXPECT_NEAR(tips[n].rotation, exact.rotation, extra_turn(n, lambda) + solved) << "λ = " << lambda;
    }
    fmt::print("{:5.1f}   {:.3e} {:.3e} {:.3e}   {:+.2e} {:+.2e}   {} {} {}   {:.2e} {:.2e} {:.2e}\n", lambda,
               errors[8], errors[16], errors[32], tips[8].rotation - exact.rotation, tips[32].rotation - exact.rotation,
               iterations[8], iterations[16], iterations[32], of_chords[8], of_chords[16], of_chords[32]);
    // the error that theory predicts vanishes where the circle closes: there is no order to observe
    for (const int n : {8, 16}) {
      if (chain(2 * n, lambda).distance(exact) <= 10 * solved) continue;
      const double order =
          observed_order(tips[n].distance(thick_strip(lambda)), tips[2 * n].distance(thick_strip(lambda)));
      EXPECT_GE(order, 1.9) << "λ = " << lambda << ", " << n << " elements";
    }
    EXPECT_LE(errors[32], 1e-3) << "λ = " << lambda;
  }
}

}  // namespace
}  // namespace sundrape

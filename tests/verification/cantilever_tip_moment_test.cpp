// B2: the moment-loaded cantilever (chapter §4.2), up to the closed circle, against its closed form.
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

using std::numbers::pi;
constexpr double ei = 3.4641016151377544e-9;  // [N m²]; L = 1 m
constexpr double solved = 1e-5;               // what the relaxation's tolerance of 1e-8 leaves, generously

/// Of n rigid edges that turn by Δ = φ/n from one to the next and by Δ/2 at the clamp, the chords subtend a circle that
/// is larger than the arc's by (Δ/2)/sin(Δ/2): so much too large is every coordinate; rotations are exact.
Tip second_order_chain(int n, double turn) {
  const double half = 0.5 * turn / n, factor = half / std::sin(half);
  return {1 - factor * std::sin(turn) / turn, factor * (1 - std::cos(turn)) / turn, turn};
}

Tip net(int cells, double lambda, int& iterations) {
  const auto b = benchmark("cantilever_tip_moment.toml",
                           {cells_along(cells), fmt::format("load.0.total=[0,{:.17g},0]", -lambda * pi * ei)});
  const auto rest = equilibrium(b, 1e-8);
  iterations = rest.result.iterations;
  const auto line = centre_line(b.model.mesh, rest.q);
  const Vector3 tip = line.back() - line.front();
  return {1 - tip.x(), tip.z(), tip_rotation(line, lambda * pi)};
}

TEST(CantileverTipMoment, EightCellsAreTheSecondOrderChainUpToTheClosedCircle) {
  for (const double lambda : {0.5, 1.0, 1.5, 2.0}) {
    int iterations = 0;
    const Tip tip = net(8, lambda, iterations), chain = second_order_chain(8, lambda * pi);
    EXPECT_LE(tip.distance(chain), solved) << "λ = " << lambda;
    EXPECT_NEAR(tip.rotation, chain.rotation, solved) << "λ = " << lambda;
  }
}

TEST(CantileverTipMomentVerification, SecondOrderFromEightToSixtyFourCellsUpToTheClosedCircle) {
  fmt::print("  λ     |tip error|/L at 8, 16, 32, 64 cells             rotation error [rad] at 8, 64   iterations\n");
  for (const auto& [lambda, exact] : arcs_of_tip_moment()) {
    std::map<int, Tip> tips;
    std::map<int, double> errors;
    std::map<int, int> iterations;
    for (const int n : {8, 16, 32, 64}) {
      tips[n] = net(n, lambda, iterations[n]);
      errors[n] = tips[n].distance(exact);
      EXPECT_LE(tips[n].distance(second_order_chain(n, lambda * pi)), solved) << "λ = " << lambda;
      EXPECT_NEAR(tips[n].rotation, exact.rotation, solved) << "λ = " << lambda;
    }
    fmt::print("{:5.1f}   {:.3e} {:.3e} {:.3e} {:.3e}   {:+.2e} {:+.2e}   {} {} {} {}\n", lambda, errors[8], errors[16],
               errors[32], errors[64], tips[8].rotation - exact.rotation, tips[64].rotation - exact.rotation,
               iterations[8], iterations[16], iterations[32], iterations[64]);
    // the error that theory predicts vanishes where the circle closes: there is no order to observe
    for (const int n : {8, 16, 32}) {
      if (second_order_chain(2 * n, lambda * pi).distance(exact) > 10 * solved) {
        EXPECT_GE(observed_order(errors[n], errors[2 * n]), 1.9) << "λ = " << lambda << ", " << n << " cells";
      }
    }
    EXPECT_LE(errors[64], 1e-3) << "λ = " << lambda;
  }
}

}  // namespace
}  // namespace sundrape

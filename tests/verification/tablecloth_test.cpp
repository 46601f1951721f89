// B4: the tablecloth of the chapter (§4.4) on the 8 cm table of its text and on the 4 cm table that its positions fit.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/square_drape.hpp"

namespace sundrape {
namespace {

using namespace square_drape;

using Settings = std::vector<std::string>;

struct Table {
  std::string falling, at_rest;  // cases
  std::string size;              // of its box
  double half = 0;               // of its flat top [m]
};
const Table table_of_text{"tablecloth.toml", "tablecloth_static.toml", "8.2 cm", 0.04};
const Table small_table{"tablecloth_small_table.toml", "tablecloth_small_table_static.toml", "4.2 cm", 0.02};

std::string cells(int n) { return fmt::format("cloth.cells=[{},{}]", n, n); }
std::string seed(int n) { return fmt::format("cloth.waviness.seed={}", n); }
const std::string unperturbed = "cloth.waviness.amplitude=\"0 mm\"";

/// Makes the damped case fall on a table of another case.
Settings damped_on(const Table& table) {
  return {fmt::format("obstacle.0.size=[\"{0}\",\"{0}\",\"8 cm\"]", table.size)};
}

TEST(Tablecloth, RestsStablyOnATableThatCarriesItsWeight) {
  for (const auto& table : {table_of_text, small_table}) {
    const auto b = benchmark(table.at_rest);
    expect_rest(b, rest_of(table.at_rest, b));
  }
}

TEST(Tablecloth, FallsWithoutSinkingIntoItsTable) {
  for (const auto& table : {table_of_text, small_table}) {
    const auto b = benchmark(table.falling, {"dynamics.duration=\"0.2 s\"", "output.frames=200"});
    EXPECT_LE(deepest(b, motion(b)), 0.1 * thickness) << table.falling;
  }
}

// A node held in x and y alone stays a block row of the system. Did a solver let it creep, the cloth would slide off:
// on a frictionless table its middle is an unstable place.
TEST(Tablecloth, ComponentsThatAreHeldStayWhereTheyAre) {
  const auto b = benchmark("tablecloth.toml", {"dynamics.duration=\"0.1 s\"", "output.frames=10"});
  const int centre = node_at(b, 0, 0);
  for (const auto& q : motion(b).position) {
    EXPECT_EQ(point(q, centre).x(), 0);
    EXPECT_EQ(point(q, centre).y(), 0);
  }
}

/// Falls from flat through thick air; what the dynamics end with is an equilibrium, and statics agree that it is one.
void falls_to_rest(const Table& table) {
  auto b = benchmark("tablecloth_damped.toml", damped_on(table));
  const auto fall = motion(b);
  const Vector end = fall.position.back();
  print(fmt::format("damped fall, {} steps", fall.statistics.steps), b, end);
  EXPECT_LE(deepest(b, fall), 0.1 * thickness);
  EXPECT_LT(fall.kinetic.back(), 1e-6 * std::ranges::max(fall.kinetic));
  expect_rest(b, end);

  const auto statics = benchmark(table.at_rest);
  const Vector relaxed = rest_of("relaxed from flat", statics);
  const auto apart = nearest_image(b, end, relaxed);
  b.model.initial = end;
  const Vector polished = equilibrium(b, 1e-9).q;
  const auto moved = distance(b, end, polished, Matrix3::Identity());
  fmt::print(
      "    fall and statics from flat are {:.3f} mm (RMS), {:.3f} mm (max) apart, up to symmetry; relaxing the end of "
      "the fall "
      "moves it by {:.1e}, {:.1e} mm\n",
      1e3 * apart.rms, 1e3 * apart.max, 1e3 * moved.rms, 1e3 * moved.max);
  expect_rest(b, polished);
  EXPECT_LE(moved.max, same_branch);
}

/// Shaken at its equilibrium by 0.5 to 1.4 mm, the cloth swings back into it. Further away are neighbouring equilibria,
/// in which points of the cloth have changed their places on the table's narrow rounding: on the 4 cm table already 0.8
/// mm lead into one, 0.64 mm away at one node.
void swings_back(const Table& table, double speed) {
  auto b = benchmark("tablecloth_damped.toml", damped_on(table));
  const Vector rest = rest_of("relaxed from flat", b);
  Vector v = Vector::Zero(rest.size());
  for (int i = 0; i < b.model.mesh.nodes(); ++i)
    if (point(rest, i).z() < -0.01)
      point(v, i).z() = speed * std::sin(40 * (point(rest, i).x() + 2 * point(rest, i).y()));
  const auto integrator = integrator_of(b);
  const auto swing = motion(*b.model.system, *integrator, b.c.output.frame_times, rest, v);
  double away = 0;
  for (const auto& q : swing.position) away = std::max(away, distance(b, q, rest, Matrix3::Identity()).max);
  const auto d = distance(b, swing.position.back(), rest, Matrix3::Identity());
  fmt::print("    shaken, it goes {:.3f} mm away and comes back within {:.1e} mm (RMS), {:.1e} mm (max)\n", 1e3 * away,
             1e3 * d.rms, 1e3 * d.max);
  b.model.initial = swing.position.back();
  EXPECT_LE(distance(b, swing.position.back(), equilibrium(b, 1e-9).q, Matrix3::Identity()).max, same_branch);
  EXPECT_LE(d.max, same_branch);
  EXPECT_GT(away, same_branch);  // else it was not shaken
}

TEST(TableclothVerification, FallsToAnEquilibriumOnTheTableOfTheText) { falls_to_rest(table_of_text); }
TEST(TableclothVerification, FallsToAnEquilibriumOnTheSmallTable) { falls_to_rest(small_table); }
TEST(TableclothVerification, SwingsBackToTheStaticStateOnTheTableOfTheText) { swings_back(table_of_text, 0.05); }
TEST(TableclothVerification, SwingsBackToTheStaticStateOnTheSmallTable) { swings_back(small_table, 0.04); }

TEST(TableclothVerification, EveryWavinessLeadsToAStableRest) {
  for (const auto& table : {table_of_text, small_table})
    for (int k = 1; k <= 10; ++k) {
      const auto b = benchmark(table.at_rest, {seed(k)});
      expect_rest(b, rest_of(fmt::format("{} cm, seed {}", 200 * table.half, k), b));
    }
}

// The equilibrium with straight corners was derived to 2 % independently of this code:
// corner (5.2, 5.2, −4.4) cm from the table's corner, midside (2.6, −5.4) cm from its edge. A symmetric start finds it.
TEST(TableclothVerification, StraightCornersAreWhereTheyWereDerivedToBe) {
  const Vector3 corner(0.092, 0.092, -0.044), midside(0.066, 0, -0.054);
  square_drape::Place p;
  for (const int n : {20, 40, 80}) {
    const auto b = benchmark(table_of_text.at_rest, {unperturbed, cells(n)});
    p = place(b, rest_of(fmt::format("8 cm, {}²", n + 1), b));
  }
  EXPECT_LE((p.corner - corner).norm(), 0.02 * side);
  EXPECT_LE((p.midside - midside).norm(), 0.02 * side);
}

// From a wavy sheet: corners folded over, which is not the derived equilibrium. How far they are from four-fold is
// printed; nothing demands that they are.
TEST(TableclothVerification, FoldedCornersOnFinerNetsRestStably) {
  for (const auto& table : {table_of_text, small_table})
    for (const int n : {40, 80}) {
      const auto b = benchmark(table.at_rest, {cells(n)});
      const Vector q = rest_of(fmt::format("{} cm, {}²", 200 * table.half, n + 1), b);
      expect_rest(b, q);
      EXPECT_GT(distance(b, q, q, symmetry(0, true)).max, same_branch);
    }
}

}  // namespace
}  // namespace sundrape

// B4: the tablecloth of the chapter (§4.4) on the 8 cm table of its text and on the 4 cm table that its positions fit.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sundrape/statics/stability.hpp"

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

constexpr double side = 0.2;                  // of the cloth, L [m]
constexpr double thickness = 0.54229e-3;      // [m]
constexpr double same_branch = 0.002 * side;  // 0.2 % of L: two equilibria that are one [m]

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

/// What a cloth at rest, or almost, says of itself.
struct Rest {
  double energy = 0;  // stored [J]
  double residual = 0;
  double carried = 0;      // by the table, over the weight
  double penetration = 0;  // [m]
  double strain = 0;       // largest of an edge
  int negative_pivots = -1;
};

Rest look(const Benchmark& b, const Vector& q) {
  const State all{0, q, Vector::Zero(q.size())};
  const auto contact = b.model.contact->report(all);
  Rest r;
  r.energy = b.model.system->energies(all).stored();
  r.residual = relative_residual(*b.model.system, all, 0);
  r.carried = contact.total_forces.at(0).z() / b.model.weight;
  r.penetration = contact.deepest_penetration;
  r.strain = b.model.edge_strains.range(q).second;
  r.negative_pivots = negative_pivots(*b.model.system, all, 1e-3 * std::sqrt(b.model.gravity / side)).value_or(-1);
  return r;
}

int node_at(const Benchmark& b, double x, double y) {
  const auto& rest = b.model.mesh.reference;
  const Vector3 there(x, y, 0);
  return static_cast<int>(std::ranges::min_element(rest, {}, [&](const Vector3& p) { return (p - there).norm(); }) -
                          rest.begin());
}

/// One of the eight symmetries of the square: quarter turns, after a reflection y → −y if asked for.
Matrix3 symmetry(int quarter_turns, bool reflected) {
  Matrix3 turn = Matrix3::Identity();
  for (int k = 0; k < quarter_turns; ++k) turn = (Matrix3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished() * turn;
  return turn * Vector3(1, reflected ? -1 : 1, 1).asDiagonal();
}

struct Distance {
  double rms = 0, max = 0;  // over the nodes [m]
};

/// How far `q` is from `other` moved by a symmetry of the square.
Distance distance(const Benchmark& b, const Vector& q, const Vector& other, const Matrix3& s) {
  Distance d;
  const auto& rest = b.model.mesh.reference;
  for (int i = 0; i < b.model.mesh.nodes(); ++i) {
    const Vector3 image = s * rest[static_cast<std::size_t>(i)];
    const double apart = (point(q, node_at(b, image.x(), image.y())) - s * point(other, i)).norm();
    d.rms += apart * apart;
    d.max = std::max(d.max, apart);
  }
  d.rms = std::sqrt(d.rms / b.model.mesh.nodes());
  return d;
}

/// The same up to the symmetries of the square, all of which a drape on a square table has.
Distance nearest_image(const Benchmark& b, const Vector& q, const Vector& other) {
  Distance nearest{1, 1};
  for (const bool reflected : {false, true})
    for (int turns = 0; turns < 4; ++turns)
      if (const auto d = distance(b, q, other, symmetry(turns, reflected)); d.rms < nearest.rms) nearest = d;
  return nearest;
}

/// Where a quarter turn leaves the drape is a four-fold one; if reflections do as well its folds stand straight,
/// otherwise all four corners are folded over the same way round. Otherwise the larger of the two decides what it is
/// closest to.
std::string branch(const Benchmark& b, const Vector& q) {
  const double turn = distance(b, q, q, symmetry(1, false)).max;
  const double reflection = distance(b, q, q, symmetry(0, true)).max;
  std::string name = reflection < same_branch ? "straight corners" : "corners folded over";
  if (turn >= same_branch) name += fmt::format(", a quarter turn leaves it within {:.1f} mm", 1e3 * turn);
  if (reflection >= same_branch) name += fmt::format(", a reflection within {:.1f} mm", 1e3 * reflection);
  return name;
}

struct Place {
  Vector3 corner;   // distances from the middle along both sides, the larger first, and the height over the table [m]
  Vector3 midside;  // distance from the middle at right angles to the side, along the side, height [m]
};

Place place(const Benchmark& b, const Vector& q) {
  Place p{point(q, node_at(b, side / 2, side / 2)), point(q, node_at(b, side / 2, 0))};
  if (p.corner.y() > p.corner.x()) std::swap(p.corner.x(), p.corner.y());
  return p;
}

void print(const std::string& name, const Benchmark& b, const Vector& q) {
  const Rest r = look(b, q);
  const Place p = place(b, q);
  fmt::print(
      "{}: energy {:.5f} mJ, residual {:.1e}, table carries weight {:+.1e}, penetration {:.4f} mm, edge strain {:.2f} "
      "%, "
      "{} negative pivots\n    corner ({:.2f}, {:.2f}, {:.2f}) cm, midside ({:.2f}, {:.2f}) cm; {}\n",
      name, 1e3 * r.energy, r.residual, r.carried - 1, 1e3 * r.penetration, 100 * r.strain, r.negative_pivots,
      100 * p.corner.x(), 100 * p.corner.y(), 100 * p.corner.z(), 100 * p.midside.x(), 100 * p.midside.z(),
      branch(b, q));
}

void expect_rest(const Benchmark& b, const Vector& q) {
  const Rest r = look(b, q);
  EXPECT_LE(r.residual, 1e-6);
  EXPECT_NEAR(r.carried, 1, 1e-4);
  EXPECT_LE(r.penetration, 0.1 * thickness);
  EXPECT_EQ(r.negative_pivots, 0);
}

Vector rest_of(const std::string& name, const Benchmark& b) {
  const auto found = equilibrium(b);
  print(fmt::format("{}, {} iterations", name, found.result.iterations), b, found.q);
  return found.q;
}

double deepest(const Benchmark& b, const Motion& m) {
  double depth = 0;
  for (const auto& q : m.position)
    depth = std::max(depth, b.model.contact->report({0, q, Vector::Zero(q.size())}).deepest_penetration);
  return depth;
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
  const Distance apart = nearest_image(b, end, relaxed);
  b.model.initial = end;
  const Vector polished = equilibrium(b, 1e-9).q;
  const Distance moved = distance(b, end, polished, Matrix3::Identity());
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
  const Distance d = distance(b, swing.position.back(), rest, Matrix3::Identity());
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
  Place p;
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

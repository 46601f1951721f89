// B3: a strip over the edge of a table (chapter §4.3) against the elastica that rests on vertical contact forces.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

constexpr double weight = 0.0255e-3 * 9.80665 / 1e-2;  // of the strip [N/m]: 0.0255 gf/cm
constexpr double edge = 4.5e-2, length = 6e-2;         // of the table, and of the strip [m]
constexpr double gram_force = 9.80665e-3;              // [N]

struct Overhang {
  double lift_off = 0;        // p, from where the strip leaves the table to its edge [m]
  double deflection = 0;      // of the tip below the table [m]
  double lift_off_force = 0;  // [N]
  double edge_force = 0;      // [N]
};

// Large-deflection elastica with vertical contact forces: derived by shooting, independently of this code.
constexpr Overhang elastica{2.12007e-2, 0.0810413e-2, 0.0135153 * gram_force, 0.0787965 * gram_force};

/// What a net or a shell says of the four quantities.
///
/// On the table the contact carries the weight w of what lies flat, up to the lift-off point x, and there the lift-off
/// force R; a mesh smears both over neighbouring nodes. Their sum and their moment about the strip's start,
///     F = w x + R,   m = ½ w x² + R x,
/// hold whatever the smearing, and give R = √(F² − 2 w m) and x = (F − R)/w: R is the excess over the weight that lies
/// flat, and x its centroid. At the edge nothing lies flat: the edge force is the force there.
Overhang read(const Benchmark& b, const Vector& q) {
  const Vector still = Vector::Zero(q.size());
  Vector contact = Vector::Zero(q.size());
  b.model.contact->add_force({0, q, still}, contact);
  Overhang o;
  double force = 0, moment = 0;
  for (int i = 0; i < b.model.mesh.nodes(); ++i) {
    const double x = point(q, i).x(), up = point(contact, i).z();
    if (x > edge - 0.5 * elastica.lift_off) {
      o.edge_force += up;
    } else {
      force += up;
      moment += up * x;
    }
  }
  o.lift_off_force = std::sqrt(force * force - 2 * weight * moment);
  o.lift_off = edge - (force - o.lift_off_force) / weight;
  o.deflection = -centre_line(b.model.mesh, q).back().z();
  return o;
}

struct Errors {
  double lift_off, deflection, lift_off_force, edge_force;
};
Errors relative_errors(const Overhang& o) {
  return {o.lift_off / elastica.lift_off - 1, o.deflection / elastica.deflection - 1,
          o.lift_off_force / elastica.lift_off_force - 1, o.edge_force / elastica.edge_force - 1};
}

const std::string net = "overhang.toml", shell = "overhang_shell.toml";

Errors errors_with(const std::string& name, int cells, std::vector<std::string> sets = {}) {
  sets.push_back(cells_along(cells));
  const auto b = benchmark(name, sets);
  const auto rest = equilibrium(b);
  const Overhang o = read(b, rest.q);
  const Errors e = relative_errors(o);
  fmt::print(
      "{} {:4} cells: p {:.5f} cm ({:+.2f} %), δ {:.6f} cm ({:+.2f} %), lift-off {:.7f} gf ({:+.2f} %), edge {:.7f} gf "
      "({:+.2f} %); {} iterations\n",
      name, cells, 100 * o.lift_off, 100 * e.lift_off, 100 * o.deflection, 100 * e.deflection,
      o.lift_off_force / gram_force, 100 * e.lift_off_force, o.edge_force / gram_force, 100 * e.edge_force,
      rest.result.iterations);
  return e;
}

TEST(Overhang, TwentyFourCellsBeatThePaper) {
  EXPECT_LT(std::abs(errors_with(net, 24).deflection), 0.19);  // chapter §4.3, its particle row
}

TEST(Overhang, ContactCarriesTheWholeStrip) {
  const auto b = benchmark("overhang.toml", {cells_along(24)});
  const auto rest = equilibrium(b);
  const auto forces = b.model.contact->total_forces({0, rest.q, Vector::Zero(rest.q.size())});
  EXPECT_NEAR(forces.at(0).z(), weight * length, 1e-6 * weight * length);
}

TEST(OverhangVerification, NinetySixCellsAreWithinOnePercentInAllFourQuantities) {
  (void)errors_with(net, 24);
  (void)errors_with(net, 48);
  const Errors e = errors_with(net, 96);
  EXPECT_LT(std::abs(e.lift_off), 0.01);
  EXPECT_LT(std::abs(e.deflection), 0.01);
  EXPECT_LT(std::abs(e.lift_off_force), 0.01);
  EXPECT_LT(std::abs(e.edge_force), 0.01);
}

TEST(Overhang, TwentyFourShellElementsMeetTheory) {
  const Errors e = errors_with(shell, 24);
  EXPECT_LT(std::abs(e.lift_off), 0.01);
  EXPECT_LT(std::abs(e.deflection), 0.01);
  EXPECT_LT(std::abs(e.edge_force), 0.005);
  EXPECT_LT(std::abs(e.lift_off_force), 0.05);  // the paper's finite elements miss it by 84 %
}

TEST(OverhangVerification, ShellElementsOfAHalfAndAQuarterLengthAreWithinHalfAPercent) {
  for (const int cells : {48, 96}) {
    const Errors e = errors_with(shell, cells);
    for (const double error : {e.lift_off, e.deflection, e.lift_off_force, e.edge_force})
      EXPECT_LT(std::abs(error), 0.005) << cells;
  }
}

// The case's contact yields by about a micrometre, which meshes finer than 48 cells show; a hundred times harder, what
// is left is the mesh. The tip falls by w a²/(2 κ G h) + (slope of transverse shear at the edge) a = 0.07 % of δ lower
// than the elastica, which does not shear, so that δ does not converge to its number.
TEST(OverhangVerification, ShellElementsOnAHardTableConverge) {
  const std::vector<std::string> hard{"contact.stiffness=\"2e6 gf/cm^3\"", "contact.smoothing=\"0.02 um\""};
  const Errors coarse = errors_with(shell, 24, hard), middle = errors_with(shell, 48, hard),
               fine = errors_with(shell, 96, hard);
  for (const auto quantity : {&Errors::lift_off, &Errors::lift_off_force, &Errors::edge_force}) {
    EXPECT_GT(observed_order(std::abs(coarse.*quantity), std::abs(middle.*quantity)), 1.8);
    EXPECT_GT(observed_order(std::abs(middle.*quantity), std::abs(fine.*quantity)), 1.8);
  }
  EXPECT_LT(std::abs(fine.deflection), 0.001);
}

}  // namespace
}  // namespace sundrape

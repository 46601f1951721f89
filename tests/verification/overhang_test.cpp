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

/// What a net says of the four quantities.
///
/// On the table the contact carries the weight w of what lies flat, up to the lift-off point x, and there the lift-off
/// force R; a net smears both over neighbouring nodes. Their sum and their moment about the strip's start,
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

Errors errors_with(int cells) {
  const auto b = benchmark("overhang.toml", {cells_along(cells)});
  const auto rest = equilibrium(b);
  const Overhang o = read(b, rest.q);
  const Errors e = relative_errors(o);
  fmt::print(
      "{:4} cells: p {:.5f} cm ({:+.2f} %), δ {:.6f} cm ({:+.2f} %), lift-off {:.7f} gf ({:+.2f} %), edge {:.7f} gf "
      "({:+.2f} %); {} iterations\n",
      cells, 100 * o.lift_off, 100 * e.lift_off, 100 * o.deflection, 100 * e.deflection, o.lift_off_force / gram_force,
      100 * e.lift_off_force, o.edge_force / gram_force, 100 * e.edge_force, rest.result.iterations);
  return e;
}

TEST(Overhang, TwentyFourCellsBeatThePaper) {
  EXPECT_LT(std::abs(errors_with(24).deflection), 0.19);  // chapter §4.3, its particle row
}

TEST(Overhang, ContactCarriesTheWholeStrip) {
  const auto b = benchmark("overhang.toml", {cells_along(24)});
  const auto rest = equilibrium(b);
  const auto report = b.model.contact->report({0, rest.q, Vector::Zero(rest.q.size())});
  EXPECT_NEAR(report.total_forces.at(0).z(), weight * length, 1e-6 * weight * length);
}

TEST(OverhangVerification, NinetySixCellsAreWithinOnePercentInAllFourQuantities) {
  (void)errors_with(24);
  (void)errors_with(48);
  const Errors e = errors_with(96);
  EXPECT_LT(std::abs(e.lift_off), 0.01);
  EXPECT_LT(std::abs(e.deflection), 0.01);
  EXPECT_LT(std::abs(e.lift_off_force), 0.01);
  EXPECT_LT(std::abs(e.edge_force), 0.01);
}

}  // namespace
}  // namespace sundrape

#include "support/square_drape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sundrape/statics/stability.hpp"

namespace sundrape::square_drape {
Rest look(const Benchmark& b, const Vector& q) {
  const State all{0, q, Vector::Zero(q.size())};
  const auto contact = b.model.contact->report(all);
  Rest r;
  r.energy = b.model.system->energies(all).stored();
  r.residual = relative_residual(*b.model.system, all, 0);
  r.carried = b.model.contact->total_forces(all).at(0).z() / b.model.weight;
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

Matrix3 symmetry(int quarter_turns, bool reflected) {
  Matrix3 turn = Matrix3::Identity();
  for (int k = 0; k < quarter_turns; ++k) turn = (Matrix3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished() * turn;
  return turn * Vector3(1, reflected ? -1 : 1, 1).asDiagonal();
}

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

Distance nearest_image(const Benchmark& b, const Vector& q, const Vector& other) {
  Distance nearest{1, 1};
  for (const bool reflected : {false, true})
    for (int turns = 0; turns < 4; ++turns)
      if (const auto d = distance(b, q, other, symmetry(turns, reflected)); d.rms < nearest.rms) nearest = d;
  return nearest;
}

Place place(const Benchmark& b, const Vector& q) {
  Place p{point(q, node_at(b, side / 2, side / 2)), point(q, node_at(b, side / 2, 0))};
  if (p.corner.y() > p.corner.x()) std::swap(p.corner.x(), p.corner.y());
  return p;
}

std::string branch(const Benchmark& b, const Vector& q) {
  const double turn = distance(b, q, q, symmetry(1, false)).max;
  const double reflection = distance(b, q, q, symmetry(0, true)).max;
  const Place p = place(b, q);
  std::string name = p.midside.x() > p.corner.x() ? "sides standing out"
                     : reflection < same_branch   ? "straight corners"
                                                  : "corners folded over";
  if (turn >= same_branch) name += fmt::format(", a quarter turn leaves it within {:.1f} mm", 1e3 * turn);
  if (reflection >= same_branch) name += fmt::format(", a reflection within {:.1f} mm", 1e3 * reflection);
  return name;
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

}  // namespace sundrape::square_drape

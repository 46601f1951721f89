#include "sundrape/force/cloth_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"
#include "sundrape/mesh/joined.hpp"

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

// a wide law, so that random nodes fall on all of it
constexpr double thickness = 3e-3, smoothing = 2e-3, stiffness = 4e6;
constexpr double cell = 0.01;

/// A square sheet, moved and turned about z.
QuadMesh sheet(int cells, const Vector3& shift = Vector3::Zero(), double angle = 0) {
  auto mesh = rectangle(cells * cell, cells * cell, cells, cells);
  const Matrix3 turn = Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
  for (auto& x : mesh.reference) x = turn * x + shift;
  return mesh;
}

/// A sheet of 3 × 3 cells in one mesh with another below it.
QuadMesh two_sheets(const Vector3& shift, double angle, int cells_below = 3) {
  const std::array sheets{sheet(cells_below), sheet(3, shift, angle)};
  return joined(sheets, std::array<std::string, 2>{"below", "above"});
}

ClothContact contact_of(const QuadMesh& mesh, double friction = 0, FrictionMatrix matrix = FrictionMatrix::secant) {
  return {ClothPairs(mesh, thickness, 2),
          {stiffness, smoothing},
          {.friction = friction, .friction_law = FrictionLaw(0.2), .friction_matrix = matrix}};
}

Vector forces(const ForceTerm& term, const State& state) {
  Vector f = Vector::Zero(state.q.size());
  term.add_force(state, f);
  return f;
}

/// Which parts of their shapes all pairs in reach have nearest to each other.
std::vector<int> features(const ClothPairs& pairs, const Vector& q) {
  std::vector<int> features;
  for (const auto& [pair, distance] : pairs.within(1.2 * thickness, q)) {
    const auto s = separation(pair.shapes, pair.at(q));
    for (const double w : s.weights) features.push_back(w != 0 ? 1 : 0);
  }
  return features;
}

/// The tangent's columns against central differences of the force, but for those that move a nearest point past a
/// corner: the second derivative of a distance jumps there.
void expect_exact_tangent(const QuadMesh& mesh, const ClothContact& contact, const TestState& state, double relative) {
  const ClothPairs pairs(mesh, thickness, 2);
  const Eigen::MatrixXd exact = dense_tangent(contact, state, 1, 0, Symmetry::unsymmetric);
  const double scale = exact.cwiseAbs().maxCoeff(), step = 3e-7;
  const auto before = features(pairs, state.q);
  int compared = 0;
  for (Eigen::Index k = 0; k < state.q.size(); ++k) {
    const auto moved = [&](double by) {
      TestState s = state;
      s.q[k] += by;
      return s;
    };
    if (features(pairs, moved(2 * step).q) != before || features(pairs, moved(-2 * step).q) != before) continue;
    ++compared;
    const Vector slope = (8 * (forces(contact, moved(step)) - forces(contact, moved(-step))) -
                          (forces(contact, moved(2 * step)) - forces(contact, moved(-2 * step)))) /
                         (12 * step);
    EXPECT_LE((exact.col(k) - slope).cwiseAbs().maxCoeff(), relative * scale) << "column " << k;
  }
  EXPECT_GT(compared, 0.9 * static_cast<double>(state.q.size()));
  expect_symmetric_tangent_is_symmetric_part(contact, state);
}

TEST(ClothContact, ForceIsTheGradientAndTangentTheHessian) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const auto mesh = two_sheets({0.003, -0.002, 0.7 * thickness}, 0.4 + 0.1 * seed);
    const auto contact = contact_of(mesh);
    const auto state = perturbed(mesh.reference, 0.4e-3, 0, seed);
    EXPECT_GT(contact.report(state).contacts, 15);
    expect_force_is_energy_gradient(contact, state, 1e-6);
    expect_exact_tangent(mesh, contact, state, 1e-6);
    expect_self_equilibrated(contact, state);
  }
}

TEST(ClothContact, CrossingEdgesHaveExactDerivatives) {
  // sheets that cut deep into each other; turned by 1° many edges are nearly parallel and count little
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const double angle : {0.35, 0.0175}) {
      const auto mesh = two_sheets({0.2 * cell, 0.3 * cell, 0.4 * thickness}, angle);
      const auto contact = contact_of(mesh);
      const auto state = perturbed(mesh.reference, angle < 0.1 ? 0.05e-3 : 0.5e-3, 0, seed);
      expect_force_is_energy_gradient(contact, state, 1e-6);
      expect_exact_tangent(mesh, contact, state, 1e-6);
    }
}

TEST(ClothContact, ExactTangentOfFriction) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto mesh = two_sheets({0.003, -0.002, 0.7 * thickness}, 0.5);
    const auto contact = contact_of(mesh, 0.4, FrictionMatrix::tangent);
    const auto state = perturbed(mesh.reference, 0.4e-3, 0.15, seed);
    expect_tangent_is_force_derivative(contact, state, 2e-5);
    const Vector f = forces(contact, state);
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < mesh.nodes(); ++i) sum += f.segment<3>(3 * i);
    EXPECT_LE(sum.norm(), 1e-10 * f.norm());
  }
}

TEST(ClothContact, FrictionDissipatesAndRigidMotionDoesNot) {
  const auto mesh = two_sheets({0.003, -0.002, 0.8 * thickness}, 0.5);
  const auto contact = contact_of(mesh, 0.4);
  expect_dissipates_what_it_says(contact, perturbed(mesh.reference, 0.1e-3, 0.3, 2), 1e-9);
}

TEST(ClothContact, FlatSheetsPressAlikeWhereverTheirNodesAre) {
  const double gap = 0.9 * thickness, half = 1.5 * cell;
  const ContactLaw law(stiffness, 0.5 * smoothing);  // edges do not reach each other
  const auto pressure = [&](double d) { return law.pressure(d - thickness + 0.25 * smoothing); };
  for (const auto& shift : {Vector3(0, 0, gap), Vector3(0.2 * cell, 0.1 * cell, gap),
                            Vector3(0.5 * cell, 0.5 * cell, gap), Vector3(1.3 * cell, -0.4 * cell, gap)})
    for (const double angle : {0.0, 0.3}) {
      const auto mesh = two_sheets(shift, angle, 9);
      const ClothContact contact(ClothPairs(mesh, thickness, 2), law, {});
      const Vector f = forces(contact, perturbed(mesh.reference, 0, 0, 1));
      // each side is seen by half: all that lies above by the pressure at the gap, and of what lies below a cell around
      // each node, which beside the upper sheet looks at its rim at a slant
      double expected = 0.5 * 9 * cell * cell * pressure(gap), up = 0;
      const Matrix3 turn = Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
      for (int i = 0; i < 100; ++i) {
        const Vector3 seen = turn.transpose() * (mesh.reference[static_cast<std::size_t>(i)] - shift);
        const Vector3 nearest(std::clamp(seen.x(), -half, half), std::clamp(seen.y(), -half, half), 0);
        const double d = (seen - nearest).norm();
        expected += 0.5 * cell * cell * pressure(d) * gap / d;
      }
      for (int i = 100; i < mesh.nodes(); ++i) up += f[3 * i + 2];
      EXPECT_NEAR(up, expected, 1e-9 * expected) << shift.transpose() << ", " << angle;
    }
}

TEST(ClothContact, AFlatSheetDoesNotTouchItselfHoweverFineItIs) {
  const auto mesh = rectangle(0.02, 0.02, 40, 40);  // 0.5 mm cells, 3 mm thick
  const auto contact = contact_of(mesh);
  const auto state = perturbed(mesh.reference, 0, 1, 1);
  EXPECT_EQ(contact.energy(state), 0);
  EXPECT_EQ(forces(contact, state).norm(), 0);
}

TEST(ClothContact, BothSidesOfASheetPushAway) {
  for (const double side : {1.0, -1.0}) {
    const auto mesh = two_sheets({0.1 * cell, 0.2 * cell, side * 0.8 * thickness}, 0.2);
    const auto contact = contact_of(mesh);
    const Vector f = forces(contact, perturbed(mesh.reference, 0, 0, 1));
    double up = 0;
    for (int i = mesh.nodes() / 2; i < mesh.nodes(); ++i) up += f[3 * i + 2];
    EXPECT_GT(side * up, 0);
  }
}

TEST(ClothContact, WhatIsComputedDoesNotDependOnWhereNodesWereBefore) {
  const auto mesh = two_sheets({0.003, -0.002, 0.8 * thickness}, 0.5);
  const auto fresh = contact_of(mesh), used = contact_of(mesh);
  const auto state = perturbed(mesh.reference, 0.4e-3, 0, 1);
  for (int i = 0; i < 30; ++i) (void)forces(used, perturbed(mesh.reference, 0.1e-3 * i, 0, static_cast<unsigned>(i)));
  EXPECT_GT(used.searches(), 1);
  EXPECT_EQ(forces(fresh, state), forces(used, state));
}

TEST(ClothContact, ElementsAreDeclaredAnewOnlyWhenNewOnesPress) {
  const auto mesh = two_sheets({0.003, -0.002, 0.8 * thickness}, 0.5);
  const auto contact = contact_of(mesh);
  EXPECT_FALSE(contact.adapt(perturbed(mesh.reference, 0, 0, 1)));
  for (unsigned seed = 1; seed < 20; ++seed) EXPECT_TRUE(contact.adapt(perturbed(mesh.reference, 0.05e-3, 0, seed)));
  EXPECT_EQ(contact.patterns(), 1);
}

TEST(ClothContact, AStepThroughTheOtherSheetIsNoticed) {
  const auto mesh = two_sheets({0.003, -0.002, thickness}, 0.5);
  const auto contact = contact_of(mesh);
  const auto start = perturbed(mesh.reference, 0, 0, 1);
  const auto moved = [&](double up) {
    auto state = start;
    for (int i = mesh.nodes() / 2; i < mesh.nodes(); ++i) state.q[3 * i + 2] += up;
    return state;
  };
  EXPECT_FALSE(contact.passage(start, moved(5 * thickness)).has_value());
  EXPECT_FALSE(contact.passage(start, moved(-0.9 * thickness)).has_value());
  EXPECT_TRUE(contact.passage(start, moved(-1.1 * thickness)).has_value());
  const auto through = contact.passage(start, moved(-20 * thickness));  // and well out of reach again
  ASSERT_TRUE(through.has_value());
  EXPECT_NEAR(through->place.z(), 0, thickness);
  EXPECT_NE(through->what.find("through"), std::string::npos);
}

TEST(ClothContact, RefusesALawWiderThanTheCloth) {
  const auto mesh = rectangle(cell, cell, 1, 1);
  EXPECT_THROW(ClothContact(ClothPairs(mesh, 1e-3, 2), {1e6, 1e-3}, {}), std::invalid_argument);
}

TEST(ClothContact, WithinTheBarrierCorrectionsHaveToBeSmallAgainstTheDistance) {
  const auto mesh = two_sheets({0.003, -0.002, thickness}, 0.5);
  const auto contact = contact_of(mesh);
  const auto apart = [&](double distance) {
    auto state = perturbed(mesh.reference, 0, 0, 1);
    for (int i = mesh.nodes() / 2; i < mesh.nodes(); ++i) state.q[3 * i + 2] = distance;
    return state;
  };
  EXPECT_TRUE(contact.settles(apart(2 * thickness), apart(0.55 * thickness)));
  EXPECT_FALSE(contact.settles(apart(0.4 * thickness), apart(0.3 * thickness)));
  EXPECT_FALSE(contact.settles(apart(0.2 * thickness), apart(0.3 * thickness)));
  EXPECT_TRUE(contact.settles(apart(0.31 * thickness), apart(0.3 * thickness)));
}

}  // namespace
}  // namespace sundrape

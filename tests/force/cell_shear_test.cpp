#include "sundrape/force/cell_shear.hpp"

#include <gtest/gtest.h>

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

constexpr double edge = 0.01, stiffness = 250 * edge * edge;  // [m]; G h A with G h = 250 N/m
const std::vector<Vector3> square{{0, 0, 0}, {edge, 0, 0}, {edge, edge, 0}, {0, edge, 0}};

CellShear one_cell(double relaxation_time) {
  return CellShear({{.nodes = {0, 1, 2, 3}, .scale = edge * edge, .rest = 0, .stiffness = stiffness}}, relaxation_time);
}

State at_rest(const Vector& q, const Vector& zero) { return {0, q, zero}; }

Vector flat(const std::vector<Vector3>& nodes) {
  Vector q(static_cast<Eigen::Index>(3 * nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) q.segment<3>(static_cast<Eigen::Index>(3 * i)) = nodes[i];
  return q;
}

TEST(CellShear, ForceIsTheGradientOfTheEnergyAndTheTangentIsExact) {
  for (const double time : {0.0, 1e-3}) expect_consistent(one_cell(time), perturbed(square, 0.3 * edge, 0.1, 11), 1e-6);
}

TEST(CellShear, RigidMotionLeavesItAtRest) {
  expect_no_force_under_rigid_motion(one_cell(1e-3), square, stiffness / edge);
}

TEST(CellShear, ForcesAndMomentsBalance) {
  expect_self_equilibrated(one_cell(1e-3), perturbed(square, 0.3 * edge, 0.1, 2));
}

TEST(CellShear, DampingTakesTheEnergyItReports) {
  expect_dissipates_what_it_says(one_cell(1e-3), perturbed(square, 0.3 * edge, 0.1, 4));
}

TEST(CellShear, StoresHalfTheModulusTimesTheShearSquared) {
  // continuum: ½ G h A γ² for a small shear γ
  const double shear = 1e-4;
  const Vector q = flat({{0, 0, 0}, {edge, 0, 0}, {edge + shear * edge, edge, 0}, {shear * edge, edge, 0}}),
               zero = Vector::Zero(12);
  EXPECT_NEAR(one_cell(0).energy(at_rest(q, zero)), 0.5 * stiffness * shear * shear,
              1e-3 * 0.5 * stiffness * shear * shear);
}

TEST(CellShear, StretchingTheThreadsOrTwistingTheCellCostsNothing) {
  const Vector zero = Vector::Zero(12);
  EXPECT_NEAR(
      one_cell(0).energy(at_rest(flat({{0, 0, 0}, {1.1 * edge, 0, 0}, {1.1 * edge, edge, 0}, {0, edge, 0}}), zero)), 0,
      1e-30);
  const double twist = 0.2 * edge;
  EXPECT_NEAR(one_cell(0).energy(at_rest(flat({{0, 0, 0}, {edge, 0, twist}, {edge, edge, 0}, {0, edge, twist}}), zero)),
              0, 1e-30);
}

TEST(CellShear, RefusesCellsWithoutArea) {
  EXPECT_THROW(CellShear({{.nodes = {0, 1, 2, 3}, .scale = 0, .rest = 0, .stiffness = 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

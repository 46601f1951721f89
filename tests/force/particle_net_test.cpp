#include "sundrape/force/particle_net.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

#include "support/force_term_checks.hpp"
#include "support/twill.hpp"

namespace sundrape {
namespace {

/// A fabric whose warp, weft and shear have nothing in common.
Fabric uneven_fabric() {
  Fabric fabric = isotropic_fabric(1e6, 0.3, 5e-4, 0.2);
  fabric.weft_membrane *= 0.6;
  fabric.weft_bending *= 0.4;
  fabric.net.compression_factor = 0.5;
  fabric.damping = {.mass = 0, .membrane = 1e-3, .bending = 3e-4};
  return fabric;
}
Fabric with_diagonal_springs() {
  Fabric fabric = uneven_fabric();
  fabric.net.diagonal_springs = true;
  fabric.net.diagonal_compression_factor = 0.3;
  return fabric;
}
MomentCurvature softer_law() {
  auto alpha = twill::alpha;
  for (auto& a : alpha) a *= 0.4;
  return MomentCurvature::polynomial(alpha, twill::max_curvature);
}
Fabric with_measured_bending() {
  Fabric fabric = uneven_fabric();
  fabric.measured_bending = {.warp = twill::law(), .weft = softer_law()};
  return fabric;
}

using Net = std::vector<std::unique_ptr<ForceTerm>>;

Net net(const QuadMesh& mesh, const Fabric& fabric, const std::vector<int>& clamped = {}) {
  std::vector<bool> held(static_cast<std::size_t>(mesh.nodes()), false);
  for (const int n : clamped) held[static_cast<std::size_t>(n)] = true;
  return particle_net(mesh, find_threads(mesh), fabric, mesh.reference, held);
}

/// Every term of a free and of a clamped sheet, crumpled by a quarter of its mean edge.
void expect_consistent_net(const QuadMesh& mesh, const std::vector<int>& clamped) {
  const auto state = perturbed(mesh.reference, 0.25 * mean_edge_length(mesh), 0.2, 11);
  for (const auto& fabric : {uneven_fabric(), with_diagonal_springs(), with_measured_bending()})
    for (const auto& held : {std::vector<int>{}, clamped})
      for (const auto& term : net(mesh, fabric, held)) expect_consistent(*term, state, 1e-6);
}

// 5 × 4 cells have 49 threads' segments, 20 cells and 38 bends: batches of all lanes and tails of every term

TEST(ParticleNet, OfARectangleIsConsistentInEveryTerm) {
  const auto mesh = rectangle(0.05, 0.036, 5, 4);
  expect_consistent_net(mesh, mesh.sets.at("left"));
}

TEST(ParticleNet, OfADiscIsConsistentInEveryTerm) {
  const auto mesh = disc(0.03, 6);
  expect_consistent_net(mesh, mesh.sets.at("boundary"));
}

TEST(ParticleNet, WarpAndWeftFollowTheirOwnMeasuredLawsTimesThePlateFactor) {
  constexpr double length = 0.06, width = 0.04, turn = 0.3;
  constexpr int along = 6, across = 4;
  const auto mesh = rectangle(length, width, along, across);
  const Fabric fabric = with_measured_bending();
  const double plate = 1 / (1 - fabric.poisson * fabric.poisson);
  for (const bool warp : {true, false}) {
    // rolled onto a cylinder: every edge along the thread keeps its length and turns by `turn` from the one before
    const double edge = warp ? length / along : width / across;
    const double bent = (warp ? length : width) - edge;  // ends carry no bending
    const double radius = 0.5 * edge / std::sin(0.5 * turn);
    Vector q(3 * static_cast<Eigen::Index>(mesh.nodes()));
    for (int n = 0; n < mesh.nodes(); ++n) {
      const auto& x = mesh.reference[static_cast<std::size_t>(n)];
      const double angle = turn * (warp ? x.x() : x.y()) / edge, height = radius * (1 - std::cos(angle));
      point(q, n) =
          warp ? Vector3(radius * std::sin(angle), x.y(), height) : Vector3(x.x(), radius * std::sin(angle), height);
    }
    double energy = 0;
    for (const auto& term : net(mesh, fabric))
      if (term->kind() == EnergyKind::bending) energy += term->energy({0, q, Vector::Zero(q.size())});
    const double expected = plate * bent * (warp ? width : length) * (warp ? 1 : 0.4) * twill::energy(turn / edge);
    EXPECT_NEAR(energy, expected, 1e-10 * expected) << (warp ? "warp" : "weft");
  }
}

}  // namespace
}  // namespace sundrape

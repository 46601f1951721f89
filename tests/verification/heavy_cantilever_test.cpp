// A heavy strip whose bending was measured as M = f(K), clamped horizontally, against the planar elastica.
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"
#include "support/planar_elastica.hpp"
#include "support/rigid_chain.hpp"
#include "support/twill.hpp"

namespace sundrape {
namespace {

constexpr double length = 0.1, width = 0.01;   // [m]
constexpr double stiffening = 30;              // of the membrane, since the elastica does not stretch
constexpr double stretch = 9e-5 / stiffening;  // w L/(E h)

Benchmark heavy_strip(int cells) {
  Case c;
  c.analysis = Analysis::relaxation;
  c.sheet().cloth.shape = RectangleShape{.length = length, .width = width, .cells_warp = cells, .cells_weft = 1};
  c.sheet().cloth.waviness_given = true;  // none: one equilibrium, and no saddle
  c.sheet().fabric = isotropic_fabric(60446 * 98.0665, 0, 0.0489e-2, twill::weight / 9.80665);
  c.sheet().fabric.warp_membrane *= stiffening;
  c.sheet().fabric.weft_membrane *= stiffening;
  c.sheet().fabric.shear_membrane *= stiffening;
  c.sheet().fabric.measured_bending = {.warp = twill::law(), .weft = twill::law()};
  c.sheet().fabric.warp_bending = c.sheet().fabric.weft_bending = twill::alpha[0];
  c.fixes.push_back({.name = "clamp", .nodes = NamedSet{"left"}, .source = {}});
  c.loads.push_back({.load = GravityLoad{}, .source = {}});
  CaseModel model = build_model(c);
  return {std::move(c), std::move(model)};
}

/// Place of the tip from the clamp, x and z [m].
Eigen::Vector2d tip(int cells, int* iterations = nullptr) {
  const auto b = heavy_strip(cells);
  const auto rest = equilibrium(b);
  if (iterations != nullptr) *iterations = rest.result.iterations;
  const auto line = centre_line(b.model.mesh, rest.q);
  const Vector3 way = line.back() - line.front();
  EXPECT_NEAR(way.y(), 0, 1e-6 * length);
  return {way.x(), way.z()};
}

TEST(HeavyCantilever, OfMeasuredBendingIsTheSecondOrderChain) {
  const RigidChain chain{.moment = twill::moment, .slope = twill::slope, .length = length, .weight = twill::weight};
  for (const int n : {10, 25}) EXPECT_LE((tip(n) - chain.tip(n)).norm(), 2 * stretch * length) << n << " cells";
}

TEST(HeavyCantileverVerification, OfMeasuredBendingConvergesToTheElasticaWithSecondOrder) {
  const auto exact = PlanarElastica{.law = twill::law(), .length = length, .weight = twill::weight}.solve();
  fmt::print("elastica's tip at ({:.6f}, {:.6f}) cm\ncells   tip [cm]                 error/L   order  iterations\n",
             100 * exact.tip.x(), 100 * exact.tip.y());
  std::map<int, double> errors;
  for (const int n : {10, 20, 40, 80}) {
    int iterations = 0;
    const Eigen::Vector2d at = tip(n, &iterations);
    errors[n] = (at - exact.tip).norm() / length;
    const double order = n > 10 ? observed_order(errors[n / 2], errors[n]) : 0;
    fmt::print("{:5d}   ({:.6f}, {:.6f})   {:.2e}  {:.2f}   {}\n", n, 100 * at.x(), 100 * at.y(), errors[n], order,
               iterations);
    if (n > 10) {
      EXPECT_GE(order, 1.9) << n << " cells";
    }
  }
  EXPECT_LE(errors[80], 2e-4);
}

}  // namespace
}  // namespace sundrape

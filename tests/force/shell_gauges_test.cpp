#include "sundrape/force/shell_gauges.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

constexpr double director_length = 0.004;  // [m]

ShellSection section() {
  ShellSection s;
  s.membrane = Vector3(300, 200, 80).asDiagonal();
  s.membrane(0, 1) = s.membrane(1, 0) = 50;
  s.shear = 90;
  s.bending = PlateBending(Eigen::Matrix3d(Vector3(3e-5, 2e-5, 1e-5).asDiagonal()));
  return s;
}

struct Sheet {
  QuadMesh mesh = rectangle(0.04, 0.03, 4, 3);
  ShellGauges gauges{shell_elements(mesh, std::vector<Vector3>(20, Vector3::UnitZ())),
                     section(),
                     {.director_length = director_length}};

  /// Readings where position and director are functions of the place at rest.
  template <class Motion>
  [[nodiscard]] ShellReadings read(const Motion& motion) const {
    Vector q(6 * mesh.nodes());
    for (int i = 0; i < mesh.nodes(); ++i) {
      const auto [x, t] = motion(mesh.reference[static_cast<std::size_t>(i)]);
      point(q, i) = x;
      point(q, mesh.nodes() + i) = director_length * t;
    }
    return gauges.read(q);
  }
};

using Moved = std::pair<Vector3, Vector3>;

TEST(ShellGauges, ReadUniformStretchAndShearInThePlane) {
  const Sheet sheet;
  const double a = 1.03, b = 0.98, c = 0.05;  // deformation gradient [[a, c], [0, b]]
  const auto r = sheet.read([&](const Vector3& x) {
    return Moved{{a * x[0] + c * x[1], b * x[1], 0}, Vector3::UnitZ()};
  });
  const Vector3 strain(0.5 * (a * a - 1), 0.5 * (b * b + c * c - 1), a * c);  // Green–Lagrange
  for (Eigen::Index e = 0; e < 12; ++e) {
    EXPECT_LE((r.membrane_strain.row(e).transpose() - strain).norm(), 1e-12);
    EXPECT_LE((r.membrane_force.row(e).transpose() - section().membrane * strain).norm(), 1e-9);
    EXPECT_LE(r.shear_strain.row(e).norm() + r.curvature.row(e).norm(), 1e-12);
  }
}

TEST(ShellGauges, ReadTransverseShearOfLeaningDirectors) {
  const Sheet sheet;
  const Vector3 lean = Vector3(0.1, -0.2, 1).normalized();
  const auto r = sheet.read([&](const Vector3& x) { return Moved{x, lean}; });
  for (Eigen::Index e = 0; e < 12; ++e) {
    EXPECT_NEAR(r.shear_strain(e, 0), lean[0], 1e-12);
    EXPECT_NEAR(r.shear_strain(e, 1), lean[1], 1e-12);
    EXPECT_NEAR(r.shear_force(e, 1), 90 * lean[1], 1e-9);
  }
}

TEST(ShellGauges, ReadTheCurvatureOfACylinder) {
  const Sheet sheet;
  const double radius = 0.02, edge = 0.01 / radius;
  const double shrink = 2 * std::sin(edge / 2) / edge;  // chords are shorter than their arcs
  const auto r = sheet.read([&](const Vector3& x) {
    const double turn = x[0] / radius;
    return Moved{{radius * std::sin(turn), x[1], radius * (1 - std::cos(turn))}, {-std::sin(turn), 0, std::cos(turn)}};
  });
  for (Eigen::Index e = 0; e < 12; ++e) {
    EXPECT_NEAR(r.curvature(e, 0), -shrink / radius, 1e-9);  // t,x points back along the threads
    EXPECT_NEAR(r.curvature(e, 1), 0, 1e-12);
    EXPECT_NEAR(r.moment(e, 0), -3e-5 * shrink / radius, 1e-12);
    EXPECT_NEAR(r.membrane_strain(e, 0), 0.5 * (shrink * shrink - 1), 1e-12);
    EXPECT_NEAR(r.shear_strain(e, 0), 0, 1e-12);
  }
}

TEST(ShellGauges, ReadTheEngineeringTwistOnce) {
  const Sheet sheet;
  const double twist = 0.1;  // w = κ₁₂ x y, small
  const auto r = sheet.read([&](const Vector3& x) {
    return Moved{{x[0], x[1], twist * x[0] * x[1]}, {-twist * x[1], -twist * x[0], 1}};
  });
  for (Eigen::Index e = 0; e < 12; ++e) {
    EXPECT_NEAR(r.curvature(e, 2), -2 * twist, 1e-9);
    EXPECT_NEAR(r.moment(e, 2), -1e-5 * 2 * twist, 1e-13);
  }
}

}  // namespace
}  // namespace sundrape

#include "sundrape/force/shell.hpp"

#include <cmath>
#include <functional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

#include "support/force_term_checks.hpp"
#include "support/shell_samples.hpp"

namespace sundrape {
namespace {

using Law = ShellSampleOptions::Law;

constexpr std::array fields{MembraneField::centre, MembraneField::bilinear, MembraneField::edge_tied,
                            MembraneField::mixed};
constexpr std::array measures{CurvatureMeasure::chord, CurvatureMeasure::geodesic};

/// Every kind of shell that can be chosen.
std::vector<ShellSampleOptions> every_kind() {
  std::vector<ShellSampleOptions> kinds;
  for (const auto field : fields)
    for (const auto measure : measures) kinds.push_back({.membrane = field, .curvature = measure});
  for (const auto law : {Law::orthotropic, Law::energy, Law::paper}) {
    kinds.push_back({.law = law});
    kinds.push_back({.law = law, .poisson = 0.1, .membrane_damping = 1e-3, .bending_damping = 3e-4});
  }
  kinds.push_back({.membrane_damping = 1e-3});
  kinds.push_back({.bending_damping = 3e-4});
  return kinds;
}

/// Strained, sheared and bent by up to half a radian an element.
TestState bent(const ShellSample& s, unsigned seed) {
  auto state = perturbed(s.points(), 0.0008, 0.1, seed);
  for (int i = 0; i < s.mesh.nodes(); ++i) point(state.q, s.mesh.nodes() + i) *= 1.02;
  return state;
}

Vector flat(const std::vector<Vector3>& points) {
  Vector q(static_cast<Eigen::Index>(3 * points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) q.segment<3>(static_cast<Eigen::Index>(3 * i)) = points[i];
  return q;
}

/// K at rest, of the shell with its directors.
Eigen::MatrixXd stiffness(const ShellSample& s) {
  const Vector q = flat(s.points()), v = Vector::Zero(q.size());
  return -dense_tangent(*s.shell, {0, q, v}, 1, 0, Symmetry::symmetric) -
         dense_tangent(*s.length, {0, q, v}, 1, 0, Symmetry::symmetric);
}

QuadMesh one_element(bool curved) {
  auto mesh = rectangle(0.01, 0.01, 1, 1);
  mesh.reference = {{0, 0, 0}, {0.011, 0.001, 0}, {-0.001, 0.009, 0}, {0.012, 0.011, 0}};
  if (curved) mesh.reference[3][2] = 0.001;
  return mesh;
}

TEST(Shell, ForceIsTheGradientOfTheEnergyAndTheTangentIsExact) {
  for (const bool curved : {false, true})
    for (const auto& mesh : {distorted_patch(curved), one_element(curved)})  // the second spans the sheet
      for (const auto& kind : every_kind()) {
        const auto s = shell_sample(mesh, kind);
        const auto state = bent(s, 8);  // no curvature next to 0, where f'' of an odd polynomial jumps
        expect_tangent_is_force_derivative(*s.shell, state, 1e-6);
        if (kind.law != Law::paper) expect_force_is_energy_gradient(*s.shell, state, 1e-6);
      }
}

TEST(Shell, SymmetricAssemblyIsTheSymmetricPartOfTheWholeTangent) {
  for (const auto& kind : every_kind())
    for (const auto& mesh : {distorted_patch(true), one_element(true)}) {
      const auto s = shell_sample(mesh, kind);
      auto state = bent(s, 3);
      state.v.setZero();
      const Eigen::MatrixXd whole = dense_tangent(*s.shell, state, 0.7, 0.02, Symmetry::unsymmetric);
      const Eigen::MatrixXd kept = dense_tangent(*s.shell, state, 0.7, 0.02, Symmetry::symmetric);
      EXPECT_LE((kept - 0.5 * (whole + whole.transpose())).cwiseAbs().maxCoeff(), 1e-12 * whole.cwiseAbs().maxCoeff());
      const double skew = (whole - whole.transpose()).cwiseAbs().maxCoeff() / whole.cwiseAbs().maxCoeff();
      if (kind.law == Law::paper && kind.poisson > 0)
        EXPECT_GT(skew, 1e-6);
      else
        EXPECT_LE(skew, 1e-12);
    }
}

TEST(Shell, RigidMotionLeavesItAtRest) {
  for (const auto& kind : every_kind()) {
    const auto s = shell_sample(distorted_patch(true), kind);
    const auto rest = s.points();
    const auto nodes = static_cast<std::size_t>(s.mesh.nodes());
    for (const double angle : {0.0, 1.0, 2.9}) {
      const Matrix3 turn = Eigen::AngleAxisd(angle, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
      const Vector3 spin(3, 1, -2);
      TestState moved;
      moved.q = moved.v = flat(rest);
      for (std::size_t i = 0; i < rest.size(); ++i) {
        const auto p = static_cast<int>(i);
        const Vector3 turned = turn * rest[i];
        point(moved.q, p) = turned + (i < nodes ? Vector3(0.3, -0.1, 0.2) : Vector3(0, 0, 0));
        point(moved.v, p) = spin.cross(turned) + (i < nodes ? Vector3(0.5, 0.1, -1) : Vector3(0, 0, 0));
      }
      Vector f = Vector::Zero(moved.q.size());
      s.shell->add_force(moved, f);
      s.length->add_force(moved, f);
      EXPECT_LE(f.cwiseAbs().maxCoeff(), 1e-10 * s.membrane * 0.01) << "turned by " << angle;
      EXPECT_LE(s.shell->dissipated_power(moved), 1e-15);
    }
  }
}

TEST(Shell, ForcesAndMomentsBalance) {
  for (const auto& kind : every_kind()) {
    const auto s = shell_sample(distorted_patch(true), kind);
    const auto state = bent(s, 12);
    Vector f = Vector::Zero(state.q.size());
    s.shell->add_force(state, f);
    Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
    for (int i = 0; i < 2 * s.mesh.nodes(); ++i) {
      if (i < s.mesh.nodes()) sum += point(f, i);
      moment += Vector3(point(state.q, i)).cross(Vector3(point(f, i)));
    }
    EXPECT_LE(sum.norm(), 1e-10 * f.norm());
    EXPECT_LE(moment.norm(), 1e-10 * f.norm() * 0.03);
  }
}

TEST(Shell, DampingTakesTheEnergyItReports) {
  for (const auto law : {Law::isotropic, Law::energy, Law::paper}) {
    const auto s = shell_sample(distorted_patch(true), {.law = law, .membrane_damping = 1e-3, .bending_damping = 3e-4});
    expect_dissipates_what_it_says(*s.shell, bent(s, 4), 1e-8);
    expect_dissipates_what_it_says(*s.length, bent(s, 4), 1e-8);
  }
}

TEST(DirectorLength, ForceIsTheGradientOfTheEnergyAndTheTangentIsExact) {
  const auto s = shell_sample(distorted_patch(false), {.membrane_damping = 1e-3});
  expect_consistent(*s.length, bent(s, 5), 1e-6);
}

TEST(Shell, OneElementAndAPatchHaveExactlySixRigidModes) {
  for (const bool curved : {false, true})
    for (const auto field : fields)
      for (const auto& mesh : {one_element(curved), distorted_patch(curved)}) {
        const auto k = stiffness(shell_sample(mesh, {.membrane = field}));
        const Vector values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
        EXPECT_GE(values[0], -1e-10 * values[values.size() - 1]);
        int zero = 0;
        // the softest mode that is none of a rigid body bends: B against E h l², times the softness of a corner
        for (const double value : values) zero += value < 1e-10 * values[values.size() - 1] ? 1 : 0;
        EXPECT_EQ(zero, 6) << "field " << static_cast<int>(field) << ", curved " << curved;
      }
}

/// Solves for the free points when the boundary follows a linearised motion, and compares with it inside.
/// @param directors_follow  whether the directors inside are given too: constant shear without bending needs couples
void expect_patch_test(const ShellSample& s, const std::function<std::pair<Vector3, Vector3>(const Vector3&)>& motion,
                       const char* name, bool directors_follow = false) {
  const int n = s.mesh.nodes();
  Vector exact(6 * n);
  for (int i = 0; i < n; ++i) {
    const auto [u, t] = motion(s.mesh.reference[static_cast<std::size_t>(i)]);
    point(exact, i) = u;
    point(exact, n + i) = ShellSample::director_length * t;
  }
  const Eigen::MatrixXd k = stiffness(s);
  std::vector<Eigen::Index> inside, outside;
  const auto boundary = boundary_nodes(s.mesh);
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < 3; ++j)
      (std::ranges::find(boundary, i % n) == boundary.end() && !(directors_follow && i >= n) ? inside : outside)
          .push_back(3 * i + j);
  ASSERT_FALSE(inside.empty());
  const Vector found = k(inside, inside).ldlt().solve(-k(inside, outside) * exact(outside));
  EXPECT_LE((found - exact(inside)).cwiseAbs().maxCoeff(), 1e-10 * exact.cwiseAbs().maxCoeff()) << name;
}

TEST(Shell, PatchTestsOnDistortedElements) {
  for (const auto field : {MembraneField::centre, MembraneField::bilinear, MembraneField::mixed})
    for (const auto measure : measures)
      for (const auto law : {Law::isotropic, Law::orthotropic}) {
        const auto s = shell_sample(distorted_patch(false), {.membrane = field, .curvature = measure, .law = law});
        const Vector3 up(0, 0, 1);
        using Motion = std::pair<Vector3, Vector3>;
        expect_patch_test(
            s,
            [](const Vector3& x) {
              return Motion{{x[0] + 0.2 * x[1], 0.3 * x[0] - 0.4 * x[1], 0}, Vector3::Zero()};
            },
            "membrane");
        expect_patch_test(
            s,
            [](const Vector3& x) {
              return Motion{{0, 0, 0.3 * x[0] + 0.1 * x[1]}, Vector3::Zero()};
            },
            "transverse shear", true);
        for (const auto& [k, name] :
             {std::pair{Vector3(1, 0, 0), "bending"}, std::pair{Vector3(0.5, -0.8, 0), "double bending"},
              std::pair{Vector3(0, 0, 1), "twist"}})
          expect_patch_test(
              s,
              [k = k](const Vector3& x) {
                const double w = 0.5 * (k[0] * x[0] * x[0] + k[1] * x[1] * x[1]) + k[2] * x[0] * x[1];
                return Motion{{0, 0, w}, {-k[0] * x[0] - k[2] * x[1], -k[1] * x[1] - k[2] * x[0], 0}};
              },
              name);
      }
}

TEST(Shell, TheEdgeTiedMembraneFailsThePatchTestOfDistortedElements) {
  // why it is no default: the error is of the size of the strain itself
  const auto s = shell_sample(distorted_patch(false), {.membrane = MembraneField::edge_tied});
  const Vector rest = flat(s.points()), zero = Vector::Zero(rest.size());
  Vector q = rest;
  for (int i = 0; i < s.mesh.nodes(); ++i) q[3 * i] *= 1 + 1e-6;
  Vector f = zero;
  s.shell->add_force({0, q, zero}, f);
  const auto boundary = boundary_nodes(s.mesh);
  double worst = 0;
  for (int i = 0; i < s.mesh.nodes(); ++i)
    if (std::ranges::find(boundary, i) == boundary.end()) worst = std::max(worst, point(f, i).norm());
  EXPECT_GT(worst, 0.01 * 1e-6 * s.membrane * 0.01);
}

/// Energy of a sheet 1 cm wide bent into an arc of a circle about y.
double energy_of_arc(int cells, double turn, CurvatureMeasure measure, double poisson) {
  const double length = 0.1, width = 0.01, radius = length / turn;
  const auto s = shell_sample(rectangle(length, width, cells, 1), {.curvature = measure, .poisson = poisson});
  Vector q = flat(s.points());
  for (int i = 0; i < s.mesh.nodes(); ++i) {
    const Vector3 x = s.mesh.reference[static_cast<std::size_t>(i)];
    const double angle = x[0] / radius, edge = turn / cells;
    const double on_chord = radius * edge / (2 * std::sin(edge / 2));  // keeps the lengths of the chords
    point(q, i) = Vector3(on_chord * std::sin(angle), x[1], on_chord * (1 - std::cos(angle)));
    point(q, s.mesh.nodes() + i) = ShellSample::director_length * Vector3(-std::sin(angle), 0, std::cos(angle));
  }
  const Vector zero = Vector::Zero(q.size());
  Energies e;
  s.shell->add_energies({0, q, zero}, e);
  // the element's own shear of a chord is none: directors are symmetric about each
  EXPECT_LE(e.membrane + e.shear, 1e-9 * e.bending + 1e-20);
  const double exact = 0.5 * s.bending / (1 - poisson * poisson) * length * width / (radius * radius);
  return e.bending / exact;
}

TEST(Shell, StoresTheEnergyOfACylinderExactlyWithTheGeodesicFactor) {
  for (const double poisson : {0.0, 0.3}) {
    EXPECT_NEAR(energy_of_arc(8, 2 * 3.14159265358979, CurvatureMeasure::geodesic, poisson), 1, 2e-5);
    // per element of turn Δ the chord measure is 2 sin(Δ/2)/Δ of the curvature (DESIGN: 10 % off at a full circle)
    const double delta = 2 * 3.14159265358979 / 8, expected = std::pow(2 * std::sin(delta / 2) / delta, 2);
    EXPECT_NEAR(energy_of_arc(8, 2 * 3.14159265358979, CurvatureMeasure::chord, poisson), expected, 2e-5);
  }
}

TEST(Shell, FanningOutDirectorsOfAStripDoNotLetItsMomentGo) {
  // an arc whose directors lean outwards on both sides: without the lateral factor that would shorten what bends, and a
  // bend that is narrower than the strip is wide (here by three) would throw its directors sideways
  const double length = 0.1, width = 0.1, turn = 6.28;
  const auto s = shell_sample(rectangle(length, width, 8, 1), {.poisson = 0});
  const auto energy = [&](double lean) {
    Vector q = flat(s.points());
    for (int i = 0; i < s.mesh.nodes(); ++i) {
      const Vector3 x = s.mesh.reference[static_cast<std::size_t>(i)];
      const double angle = x[0] / length * turn, edge = turn / 8;
      const double radius = length / turn * edge / (2 * std::sin(edge / 2)), side = x[1] > 0 ? 1 : -1;
      point(q, i) = Vector3(radius * std::sin(angle), x[1], radius * (1 - std::cos(angle)));
      const Vector3 up(-std::sin(angle), 0, std::cos(angle));
      point(q, s.mesh.nodes() + i) =
          ShellSample::director_length * (std::cos(lean) * up + side * std::sin(lean) * Vector3::UnitY());
    }
    Energies e;
    s.shell->add_energies({0, q, Vector::Zero(q.size())}, e);
    return e.bending;
  };
  double before = energy(0);
  for (const double lean : {0.1, 0.2, 0.3, 0.5, 0.8}) {
    EXPECT_GT(energy(lean), before) << lean;
    before = energy(lean);
  }
}

TEST(Shell, AStripOneElementWideIsNotSoftInItsPlane) {
  // ends turned against each other in the plane: a rectangle under constant moment bends with E h w³/12 (Euler)
  const double length = 0.1, width = 0.01;
  const auto s = shell_sample(rectangle(length, width, 10, 1), {.poisson = 0});
  Vector q = flat(s.points());
  const double curvature = 1e-4 / length;
  for (int i = 0; i < s.mesh.nodes(); ++i) {
    const Vector3 x = s.mesh.reference[static_cast<std::size_t>(i)];
    point(q, i) += Vector3(-curvature * x[0] * x[1], 0.5 * curvature * x[0] * x[0], 0);
  }
  const double found = s.shell->energy({0, q, Vector::Zero(q.size())});
  const double exact = 0.5 * s.membrane * std::pow(width, 3) / 12 * curvature * curvature * length;
  EXPECT_NEAR(found / exact, 1, 0.01);
}

TEST(Shell, RefusesElementsThatFoldOver) {
  auto mesh = rectangle(0.01, 0.01, 1, 1);
  mesh.reference[3] = {-0.002, -0.002, 0};
  EXPECT_THROW((void)shell_sample(mesh, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

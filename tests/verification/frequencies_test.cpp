// B11: natural frequencies of the clamped-free strip without gravity against Euler and Bernoulli's beam.
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

constexpr std::array<double, 3> theory{0.82384, 5.16289, 14.4562};  // (βL)²/(2πL²) √(B g/w), BENCHMARKS' twill [Hz]

const std::string net = "swing.toml", shell = "swing_shell.toml";

Benchmark strip(int cells, std::vector<std::string> sets = {}, const std::string& name = net) {
  sets.push_back(cells_along(cells));
  sets.emplace_back("load.0.acceleration=[0,0,0]");
  return benchmark(name, sets);
}

struct Modes {
  Vector frequencies;      // ascending [Hz]
  Eigen::MatrixXd shapes;  // of all nodes, 3N rows
};

/// Motions of a strip's unknowns in which a column moves as one: up and down, and with a shell's directors tilting
/// along the strip; one a column of the matrix. The clamped column stays.
Eigen::MatrixXd cylinder_motions(const Benchmark& b) {
  const auto& row_of_point = b.model.system->unknowns().row_of_point();
  const auto across = columns(b.model.mesh);
  const auto free = static_cast<Eigen::Index>(across.size()) - 1;
  Eigen::MatrixXd motions =
      Eigen::MatrixXd::Zero(b.model.system->unknowns().size(), b.model.has_directors() ? 2 * free : free);
  for (Eigen::Index c = 0; c < free; ++c)
    for (const int i : across[static_cast<std::size_t>(c) + 1]) {
      motions(3 * row_of_point[static_cast<std::size_t>(i)] + 2, c) = 1;
      if (!b.model.has_directors()) continue;
      motions(3 * row_of_point[static_cast<std::size_t>(b.model.mesh.nodes() + i)], free + c) = 1;
    }
  return motions;
}

/// Modes in which a flat strip bends as a cylinder, from M φ = K φ/ω² on the space of such motions: so that the slowest
/// ones are exact to the last digits, and directors without inertia have ω = ∞. Each is checked to be a mode of the
/// whole sheet.
Modes bending_modes(const Benchmark& b, int count) {
  const auto& system = *b.model.system;
  const auto& unknowns = system.unknowns();
  BlockMatrix tangent(system.structure(), Symmetry::symmetric);
  tangent.set_zero();
  const Vector still = Vector::Zero(b.model.initial.size());
  system.add_tangent({0, b.model.initial, still}, -1, 0, tangent);
  const Eigen::MatrixXd k = tangent.dense();
  const Vector m = system.row_mass().replicate(1, 3).transpose().reshaped();

  const Eigen::MatrixXd cylinder = cylinder_motions(b);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solved(
      cylinder.transpose() * m.asDiagonal() * cylinder, cylinder.transpose() * k * cylinder);
  const Vector squares = solved.eigenvalues().tail(count).reverse().cwiseInverse();  // ω², ascending

  Modes modes{squares.cwiseSqrt() / (2 * std::numbers::pi), Eigen::MatrixXd(still.size(), count)};
  for (int j = 0; j < count; ++j) {
    const Vector rows = cylinder * solved.eigenvectors().rowwise().reverse().col(j);
    const Vector elastic = k * rows, inertial = squares[j] * m.cwiseProduct(rows);
    EXPECT_LT((elastic - inertial).norm(), 1e-6 * inertial.norm()) << "mode " << j + 1;
    Vector all = still;
    unknowns.scatter(rows, all);
    modes.shapes.col(j) = all;
  }
  return modes;
}

void expect_theory(const Benchmark& b, const std::string& name, double tolerance) {
  const auto modes = bending_modes(b, 3);
  for (int j = 0; j < 3; ++j) {
    const double expected = theory[static_cast<std::size_t>(j)];
    fmt::print("{}, mode {}: {:.5f} Hz ({:+.3f} %)\n", name, j + 1, modes.frequencies[j],
               100 * (modes.frequencies[j] / expected - 1));
    EXPECT_NEAR(modes.frequencies[j], expected, tolerance * expected);
  }
}
constexpr double net_tolerance = 0.005, shell_tolerance = 0.002;
const std::vector<std::string> massless{"shell.director=massless", "dynamics.integrator=ida"};

TEST(Frequencies, FirstThreeOfTheClampedStripAreTheBeams) { expect_theory(strip(60), "60 cells", net_tolerance); }

TEST(Frequencies, FirstThreeOfTheClampedShellAreTheBeams) {
  expect_theory(strip(60, {}, shell), "60 elements", shell_tolerance);
  expect_theory(strip(60, massless, shell), "60 elements, massless directors", shell_tolerance);
}

using Errors = std::array<double, 3>;
Errors errors_with(int cells, const std::string& name, const std::vector<std::string>& sets = {}) {
  const auto modes = bending_modes(strip(cells, sets, name), 3);
  Errors errors{};
  for (std::size_t j = 0; j < 3; ++j)
    errors[j] = std::abs(modes.frequencies[static_cast<Eigen::Index>(j)] / theory[j] - 1);
  return errors;
}

TEST(FrequenciesVerification, ConvergeToTheBeamsWithSecondOrder) {
  const Errors coarse = errors_with(20, net), fine = errors_with(80, net);
  for (std::size_t j = 0; j < 3; ++j) EXPECT_GE(observed_order(coarse[j], fine[j], 4), 1.9) << "mode " << j + 1;
  expect_theory(strip(80), "80 cells", net_tolerance);
}

// Transverse shear and rotary inertia lower the frequency of a mode of wave number k by ½ k² (B/(κ G h) + h²/12), 0.02
// % of the third; the beam has neither.
TEST(FrequenciesVerification, ShellConvergesToTheBeamsWithSecondOrder) {
  // a hundred times the modulus with the same bending
  const std::vector<std::string> thin{"material.youngs_modulus=\"6044600 gf/cm^2\"", "shell.rotary_inertia=0.01"};
  const Errors coarse = errors_with(20, shell, thin), fine = errors_with(40, shell, thin);
  for (std::size_t j = 0; j < 3; ++j) EXPECT_GE(observed_order(coarse[j], fine[j]), 1.8) << "mode " << j + 1;
  for (const int cells : {20, 40, 80, 160})
    expect_theory(strip(cells, {}, shell), fmt::format("{} elements", cells), cells < 40 ? 0.02 : shell_tolerance);
}

/// Half a period between two passages of the tip through its place of rest.
TEST(FrequenciesVerification, FirstIsSeenInFreeVibration) {
  for (const std::string integrator : {"cvode", "ida"}) {
    const auto b = strip(40, {"dynamics.integrator=" + integrator, "dynamics.rtol=1e-6", "dynamics.atol_position=2e-8",
                              "dynamics.atol_velocity=2e-6"});
    Vector shape = bending_modes(b, 1).shapes.col(0);
    shape *= 1e-3 / shape.cwiseAbs().maxCoeff();  // 1 % of the length: linear to about its square
    std::vector<double> times;
    for (int k = 0; k <= 200; ++k) times.push_back(1.0 / theory[0] * k / 200);
    const auto solver = integrator_of(b);
    const auto m = motion(*b.model.system, *solver, times, b.model.initial + shape, Vector::Zero(shape.size()));
    std::vector<double> passages;
    for (std::size_t f = 1; f < m.time.size(); ++f) {
      const double before = centre_line(b.model.mesh, m.position[f - 1]).back().z();
      const double after = centre_line(b.model.mesh, m.position[f]).back().z();
      if (before * after < 0)
        passages.push_back(m.time[f - 1] + (m.time[f] - m.time[f - 1]) * before / (before - after));
    }
    ASSERT_EQ(passages.size(), 2u);
    const double frequency = 0.5 / (passages[1] - passages[0]);
    fmt::print("{}: {:.5f} Hz ({:+.3f} %)\n", integrator, frequency, 100 * (frequency / theory[0] - 1));
    EXPECT_NEAR(frequency, theory[0], 0.005 * theory[0]);
  }
}

}  // namespace
}  // namespace sundrape

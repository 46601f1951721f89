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

Benchmark strip(int cells, std::vector<std::string> sets = {}) {
  sets.push_back(cells_along(cells));
  sets.emplace_back("load.0.acceleration=[0,0,0]");
  return benchmark("swing.toml", sets);
}

struct Modes {
  Vector frequencies;      // ascending [Hz]
  Eigen::MatrixXd shapes;  // of all nodes, 3N rows
};

/// Modes in which a flat strip bends as a cylinder, from K φ = ω² M φ on the space of equal deflections across the
/// width. Each is checked to be a mode of the whole net.
Modes bending_modes(const Benchmark& b, int count) {
  const auto& system = *b.model.system;
  const auto& unknowns = system.unknowns();
  BlockMatrix tangent(system.structure(), Symmetry::symmetric);
  tangent.set_zero();
  const Vector still = Vector::Zero(b.model.initial.size());
  system.add_tangent({0, b.model.initial, still}, -1, 0, tangent);
  const Eigen::MatrixXd k = tangent.dense();
  const Vector m = system.row_mass().replicate(1, 3).transpose().reshaped();

  const auto across = columns(b.model.mesh);
  Eigen::MatrixXd cylinder = Eigen::MatrixXd::Zero(unknowns.size(), static_cast<Eigen::Index>(across.size()) - 1);
  for (Eigen::Index c = 0; c < cylinder.cols(); ++c)  // the first column is the clamp
    for (const int i : across[static_cast<std::size_t>(c) + 1])
      cylinder(3 * unknowns.row_of_point()[static_cast<std::size_t>(i)] + 2, c) = 1;
  const Eigen::MatrixXd mass = cylinder.transpose() * m.asDiagonal() * cylinder;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solved(cylinder.transpose() * k * cylinder, mass);

  Modes modes{(solved.eigenvalues().head(count).cwiseSqrt() / (2 * std::numbers::pi)),
              Eigen::MatrixXd(still.size(), count)};
  for (int j = 0; j < count; ++j) {
    const Vector rows = cylinder * solved.eigenvectors().col(j);
    const Vector elastic = k * rows, inertial = solved.eigenvalues()[j] * m.cwiseProduct(rows);
    EXPECT_LT((elastic - inertial).norm(), 1e-6 * inertial.norm()) << "mode " << j + 1;
    Vector all = still;
    unknowns.scatter(rows, all);
    modes.shapes.col(j) = all;
  }
  return modes;
}

void expect_theory(int cells) {
  const auto modes = bending_modes(strip(cells), 3);
  for (int j = 0; j < 3; ++j) {
    const double expected = theory[static_cast<std::size_t>(j)];
    fmt::print("{} cells, mode {}: {:.5f} Hz ({:+.3f} %)\n", cells, j + 1, modes.frequencies[j],
               100 * (modes.frequencies[j] / expected - 1));
    EXPECT_NEAR(modes.frequencies[j], expected, 0.005 * expected);
  }
}

TEST(Frequencies, FirstThreeOfTheClampedStripAreTheBeams) { expect_theory(60); }

TEST(FrequenciesVerification, ConvergeToTheBeamsWithSecondOrder) {
  std::array<double, 3> coarse{}, fine{};
  for (auto [cells, errors] : {std::pair(20, &coarse), std::pair(80, &fine)}) {
    const auto modes = bending_modes(strip(cells), 3);
    for (std::size_t j = 0; j < 3; ++j)
      (*errors)[j] = std::abs(modes.frequencies[static_cast<Eigen::Index>(j)] / theory[j] - 1);
  }
  for (std::size_t j = 0; j < 3; ++j) EXPECT_GE(observed_order(coarse[j], fine[j], 4), 1.9) << "mode " << j + 1;
  expect_theory(80);
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

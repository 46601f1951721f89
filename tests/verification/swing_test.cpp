// B9: a strip of twill, clamped horizontally and let go, against a derived reference accurate to 3e-5 of its length.
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sundrape/integrate/stability_limit.hpp"

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

constexpr double length = 0.1;  // [m]

/// Largest distance of the tip from the reference over 0–0.3 s, over the length.
double largest_tip_error(const Benchmark& b, const Motion& motion) {
  const auto reference = reference_table("swing_clamped_twill.csv");
  const auto &times = reference.at("t_s"), &x = reference.at("x_tip_cm"), &z = reference.at("z_tip_cm");
  double largest = 0;
  std::size_t compared = 0;
  for (std::size_t f = 0; f < motion.time.size(); ++f)
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (std::abs(times[k] - motion.time[f]) > 1e-9) continue;
      const Vector3 tip = centre_line(b.model.mesh, motion.position[f]).back();
      largest = std::max(largest, std::hypot(tip.x() - 0.01 * x[k], tip.z() - 0.01 * z[k]) / length);
      ++compared;
    }
  EXPECT_EQ(compared, motion.time.size());
  EXPECT_NEAR(motion.time.back(), 0.3, 1e-9);
  return largest;
}

double error_with(const std::vector<std::string>& sets, const std::string& name = "swing.toml") {
  const auto b = benchmark(name, sets);
  const auto m = motion(b);
  const double error = largest_tip_error(b, m);
  fmt::print("{} {}: tip within {:.3f} % of L; {} steps, {} Newton iterations\n", name, fmt::join(sets, " "),
             100 * error, m.statistics.steps, m.statistics.newton_iterations);
  return error;
}

TEST(Swing, TipFollowsTheReferenceWithTheCaseAsItStands) {
  EXPECT_LT(error_with({"dynamics.integrator=cvode"}), 0.005);
  EXPECT_LT(error_with({"dynamics.integrator=ida"}), 0.005);
  for (const int order : {2, 3, 4, 5})
    EXPECT_LT(error_with({"dynamics.integrator=dirk", fmt::format("dynamics.max_order={}", order)}), 0.005);
}

TEST(SwingVerification, TipErrorFallsWithTheMeshAndWithTheTolerance) {
  for (const std::string integrator : {"cvode", "ida", "dirk"}) {
    std::map<int, std::map<std::string, double>> errors;
    for (const int n : {40, 80, 160})
      for (const std::string rtol : {"1e-4", "1e-5", "1e-6"})
        errors[n][rtol] = error_with({"dynamics.integrator=" + integrator, cells_along(n), "dynamics.rtol=" + rtol});
    for (auto& [n, by_rtol] : errors) {
      EXPECT_LT(by_rtol["1e-5"], by_rtol["1e-4"]) << integrator << ", " << n << " cells";
      EXPECT_LT(by_rtol["1e-6"], by_rtol["1e-5"]) << integrator << ", " << n << " cells";
    }
    EXPECT_LT(errors[80]["1e-6"], errors[40]["1e-6"]) << integrator;
    EXPECT_LT(errors[160]["1e-6"], errors[80]["1e-6"]) << integrator;
    for (const int n : {80, 160}) EXPECT_LT(errors[n]["1e-5"], 0.005) << integrator << ", " << n << " cells";
  }
}

double shell_error(std::vector<std::string> sets) { return error_with(sets, "swing_shell.toml"); }

// The reference neither stretches nor shears and has no rotary inertia; of a strip of finite thickness 0.06 % of L
// remain.
TEST(Swing, ShellFollowsTheReference) {
  EXPECT_LT(shell_error({cells_along(40), "dynamics.integrator=cvode"}), 0.001);
  EXPECT_LT(shell_error({cells_along(40), "dynamics.integrator=ida"}), 0.001);
}

TEST(SwingVerification, ShellFollowsTheReferenceWithTheCaseAsItStands) {
  EXPECT_LT(shell_error({}), 0.001);
  EXPECT_LT(shell_error({"dynamics.integrator=ida"}), 0.001);
}

TEST(SwingVerification, ShellFollowsTheReferenceWithMasslessDirectors) {
  // these need a little damping, by which their rates follow from the forces
  EXPECT_LT(shell_error({"dynamics.integrator=ida", "shell.director=massless", "material.damping.membrane=1e-6",
                         "material.damping.bending=1e-6"}),
            0.001);
}

// Ten times the modulus with the same bending, as of a strip of a third of the thickness: a tenth of the stretch, shear
// and rotary inertia that the reference has not, so the mesh alone is left.
TEST(SwingVerification, ThinShellConvergesToTheReference) {
  const std::vector<std::string> thin{"material.youngs_modulus=\"604460 gf/cm^2\"", "shell.rotary_inertia=0.1"};
  const auto with = [&](int cells) {
    auto sets = thin;
    sets.push_back(cells_along(cells));
    return shell_error(sets);
  };
  const double coarse = with(20), middle = with(40), fine = with(80);
  EXPECT_LT(middle, 0.5 * coarse);
  EXPECT_LT(fine, 0.5 * middle);
  EXPECT_LT(fine, 0.00025);
}

// Five cells of cloth that stretches 2000 times as easily, whose membrane the steps resolve: with the twill's own,
// stage order 2 shows, and all orders converge by 1.5 to 3 (docs/integrators.md).
TEST(Swing, FixedStepsOfDirkConvergeWithTheirOrder) {
  const auto end = [](int order, double step) {
    return motion(benchmark("swing.toml",
                            {"cloth.cells=[5,1]", "material.youngs_modulus=\"30 gf/cm^2\"", "dynamics.duration=0.1",
                             "dynamics.rtol=1e-10", "dynamics.integrator=dirk",
                             fmt::format("dynamics.max_order={}", order), fmt::format("dynamics.step={}", step)}))
        .position.back();
  };
  const Vector exact = end(5, 0.25e-3);
  for (const int order : {2, 3, 4, 5}) {
    const double coarse = (end(order, 4e-3) - exact).norm(), fine = (end(order, 2e-3) - exact).norm();
    EXPECT_GE(observed_order(coarse, fine), order - 0.2) << order;
    EXPECT_LE(observed_order(coarse, fine), order + 0.5) << order;
  }
}

// Both have the same mesh; CVODE's share in the tip's error is what rtol leaves of it.
TEST(SwingVerification, RungeKuttaAgreesOnAFewShellElements) {
  const auto swing = [](const std::vector<std::string>& sets) {
    const auto b = benchmark("swing_shell.toml", sets);
    const auto m = motion(b);
    std::vector<Vector3> tips;
    for (const auto& q : m.position) tips.push_back(centre_line(b.model.mesh, q).back());
    fmt::print("{}: {} steps\n", fmt::join(sets, " "), m.statistics.steps);
    return tips;
  };
  const auto implicit = swing({cells_along(10)});
  // 0.8 of the stability limit, as the command line takes: the thickness modes of the directors set it
  const auto b = benchmark("swing_shell.toml", {cells_along(10)});
  const double limit =
      rk4_stability_limit(*b.model.system, {0, b.model.initial, Vector::Zero(b.model.initial.size())}).step;
  const auto explicit_ =
      swing({cells_along(10), "dynamics.integrator=rk4", fmt::format("dynamics.step={:.17g}", 0.8 * limit)});
  ASSERT_EQ(implicit.size(), explicit_.size());
  for (std::size_t f = 0; f < implicit.size(); ++f) EXPECT_LT((implicit[f] - explicit_[f]).norm(), 0.001 * length) << f;
}

}  // namespace
}  // namespace sundrape

// B9: a strip of twill, clamped horizontally and let go, against a derived reference accurate to 3e-5 of its length.
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

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

double error_with(const std::vector<std::string>& sets) {
  const auto b = benchmark("swing.toml", sets);
  const auto m = motion(b);
  const double error = largest_tip_error(b, m);
  fmt::print("{}: tip within {:.3f} % of L; {} steps, {} Newton iterations\n", fmt::join(sets, " "), 100 * error,
             m.statistics.steps, m.statistics.newton_iterations);
  return error;
}

TEST(Swing, TipFollowsTheReferenceWithTheCaseAsItStands) {
  EXPECT_LT(error_with({"dynamics.integrator=cvode"}), 0.005);
  EXPECT_LT(error_with({"dynamics.integrator=ida"}), 0.005);
}

TEST(SwingVerification, TipErrorFallsWithTheMeshAndWithTheTolerance) {
  for (const std::string integrator : {"cvode", "ida"}) {
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

}  // namespace
}  // namespace sundrape

// A heavy strip of shell elements whose bending was measured as M = f(K), against the planar elastica and the chain of
// directors, for both ways in which a strip's law becomes a sheet's.
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sundrape/io/case_reader.hpp"

#include "support/benchmarks.hpp"
#include "support/director_chain.hpp"
#include "support/planar_elastica.hpp"
#include "support/twill.hpp"

namespace sundrape {
namespace {

constexpr double length = 0.1;                         // [m]
constexpr double membrane = 60446 * 98.0665 * 489e-6;  // E h [N/m]
constexpr double stiffening = 30;                      // of the membrane, since the elastica does not stretch
constexpr double poisson = 0.3;
const std::string stiff_membrane = "material.youngs_modulus='1813380 gf/cm^2'";  // 30 times twill's

/// f(K) of the strip as M = a f(c K)/c.
MomentCurvature law(double a = 1, double c = 1) {
  auto alpha = twill::alpha;
  for (std::size_t k = 0; k < alpha.size(); ++k) alpha[k] *= a * std::pow(c, k);
  return MomentCurvature::polynomial(alpha, twill::max_curvature / c);
}
PlanarElastica::Shape elastica(const MomentCurvature& law) {
  return PlanarElastica{.law = law, .length = length, .weight = twill::weight}.solve();
}

/// Place of the tip from the clamp, x and z [m].
Eigen::Vector2d tip(const std::vector<std::string>& sets, bool as_a_cylinder = false, int* iterations = nullptr) {
  Case c = read_case(std::filesystem::path(SUNDRAPE_SOURCE_DIR) / "cases" / "shell_heavy_cantilever.toml", sets);
  if (as_a_cylinder)
    c.fixes.push_back({.name = "plane",
                       .nodes = NamedSet{"all"},
                       .components = {false, true, false},
                       .director = {false, true, false},
                       .rotation = false,
                       .source = {}});
  CaseModel model = build_model(c);
  const Benchmark b{std::move(c), std::move(model)};
  const auto rest = equilibrium(b);
  if (iterations != nullptr) *iterations = rest.result.iterations;
  const auto line = centre_line(b.model.mesh, rest.q);
  const Vector3 way = line.back() - line.front();
  EXPECT_NEAR(way.y(), 0, 1e-6 * length);
  return {way.x(), way.z()};
}
std::string form(const std::string& name) { return "material.bending.form=" + name; }

/// What the strip has and elastica and chain have not, over L: stretch and transverse shear of its own weight, 1 + 12/5
/// times w L/(E h); and the strains M K/(E h) of mid-surface and director, each once in the curvature and once in the
/// moment, to which a curvature answers with (f/K)/f' ≤ 1.7. Strains are largest at the clamp; the tip moves by no more
/// than the extra turn.
double thickness_effect(const PlanarElastica::Shape& exact) {
  const double strain = exact.root_moment * exact.root_curvature / (stiffening * membrane);
  return (2 + 2 * 1.7) * strain * std::abs(exact.tip_angle) + 3.4 * twill::weight * length / (stiffening * membrane);
}

TEST(ShellHeavyCantilever, OfTwentyElementsIsTheElasticaInEitherForm) {
  const auto exact = elastica(law());
  const Eigen::Vector2d energy = tip({cells_along(20), form("energy")}), paper = tip({cells_along(20), form("paper")});
  EXPECT_LE((energy - exact.tip).norm(), 2e-3 * length);
  EXPECT_LE((energy - paper).norm(), 1e-6 * length);  // one and the same law for ν = 0, to the relaxation's tolerance
}

TEST(ShellHeavyCantilever, WithAStiffMembraneIsTheChainOfDirectors) {
  const DirectorChain chain{.law = law(), .length = length, .weight = twill::weight};
  const auto exact = elastica(law());
  for (const int n : {10, 25})
    EXPECT_LE((tip({cells_along(n), stiff_membrane}) - chain.solve(n).tip).norm(), thickness_effect(exact) * length)
        << n << " elements";
}

TEST(ShellHeavyCantilever, HeldInItsPlaneItBendsIntoACylinder) {
  const auto sheet = law(1 / (1 - poisson * poisson));
  const DirectorChain chain{.law = sheet, .length = length, .weight = twill::weight};
  for (const auto* name : {"energy", "paper"}) {
    const auto at = tip({cells_along(25), form(name), stiff_membrane, "material.poisson=0.3"}, true);
    EXPECT_LE((at - chain.solve(25).tip).norm(), thickness_effect(elastica(sheet)) * length) << name;
  }
}

// A strip that is free to curl across has no moment across. For `paper` f(κ₂₂) = −ν f(κ₁₁) then, and M = f(K). For
// `energy` κ₂₂ = −ν κ₁₁ and the equivalent curvature is c K, c² = 1 − ν², so that M = f(c K)/c: f itself only where it
// is linear. The clamp, where a strip cannot curl, counts over a length of its width: 1 mm.
TEST(ShellHeavyCantilever, FreeToCurlItHasTheLawOfStripsOrNearly) {
  const double c = std::sqrt(1 - poisson * poisson);
  const auto narrow = [&](const char* name) {
    return tip({cells_along(80), "cloth.size=['10 cm', '1 mm']", form(name), stiff_membrane, "material.poisson=0.3"});
  };
  const Eigen::Vector2d energy = narrow("energy"), paper = narrow("paper");
  EXPECT_LE((paper - elastica(law()).tip).norm(), 2e-3 * length);
  EXPECT_LE((energy - elastica(law(1, c)).tip).norm(), 2e-3 * length);
  EXPECT_GE((energy - paper).norm(), 2e-3 * length);  // or the lines above could not tell them apart
}

TEST(ShellHeavyCantileverVerification, ConvergesToTheElasticaWithSecondOrderInEitherForm) {
  const auto exact = elastica(law());
  fmt::print("elastica's tip at ({:.6f}, {:.6f}) cm\n", 100 * exact.tip.x(), 100 * exact.tip.y());
  for (const auto* name : {"energy", "paper"}) {
    fmt::print("form {}\nelements  tip [cm]                 error/L   order  iterations   with twill's membrane\n",
               name);
    std::map<int, double> errors;
    for (const int n : {10, 20, 40, 80}) {
      int iterations = 0;
      const Eigen::Vector2d at = tip({cells_along(n), form(name), stiff_membrane}, false, &iterations);
      errors[n] = (at - exact.tip).norm() / length;
      const double order = n > 10 ? observed_order(errors[n / 2], errors[n]) : 0;
      const double stretching = (tip({cells_along(n), form(name)}) - exact.tip).norm() / length;
      fmt::print("{:8d}  ({:.6f}, {:.6f})   {:.2e}  {:.2f}   {}          {:.2e}\n", n, 100 * at.x(), 100 * at.y(),
                 errors[n], order, iterations, stretching);
      if (n > 10) {
        EXPECT_GE(order, 1.9) << n << " elements";
      }
      EXPECT_LE(errors[n], 2e-3) << n << " elements";
      EXPECT_LE(stretching, 2e-3) << n << " elements";
    }
  }
}

TEST(ShellHeavyCantileverVerification, WidthDecidesHowFarItCurls) {
  const double c = std::sqrt(1 - poisson * poisson);
  const auto print = [](const std::string& what, const Eigen::Vector2d& at) {
    fmt::print("{:36} ({:.4f}, {:.4f}) cm\n", what, 100 * at.x(), 100 * at.y());
  };
  const auto cylinder = elastica(law(1 / (1 - poisson * poisson))).tip;
  print("strip, M = f(K)", elastica(law()).tip);
  print("strip, M = f(cK)/c", elastica(law(1, c)).tip);
  print("cylinder, M = f(K)/(1 − ν²)", cylinder);
  for (const auto* name : {"energy", "paper"}) {
    const auto free = elastica(law(1, name == std::string("energy") ? c : 1)).tip;
    double before = (free - cylinder).norm();
    for (const auto* width : {"2 mm", "5 mm", "1 cm", "2 cm"}) {
      const auto at = tip(
          {"cloth.cells=[80,8]", fmt::format("cloth.size=['10 cm', '{}']", width), form(name), "material.poisson=0.3"});
      print(fmt::format("{}, width {}, 80 × 8 elements", name, width), at);
      const double to_cylinder = (at - cylinder).norm();
      EXPECT_LT(to_cylinder, before) << name << ", " << width;  // the wider, the less it curls
      before = to_cylinder;
    }
  }
}

}  // namespace
}  // namespace sundrape

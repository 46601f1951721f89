#include "sundrape/app/sensitivities.hpp"

#include <gtest/gtest.h>

#include "sundrape/app/solver_choice.hpp"
#include "sundrape/io/case_parameter.hpp"

#include "app/sample_cases.hpp"

namespace sundrape {
namespace {

// The method is exact up to rounding. What it is held against, central differences of whole solutions over ±0.1 %, is
// off by some 10⁻⁶ for its curvature, and by what the solutions leave out of balance.
constexpr double change = 1e-3, agreement = 1e-4, balance = 1e-10;

Vector relaxed(const CaseModel& model, const Case& c, Vector q) {
  auto options = relaxation_options(c, model);
  options.tolerance = balance;
  const auto solver = make_linear_solver(model.system->has_symmetric_tangent() ? SolverKind::cholesky : SolverKind::lu);
  UnseenRelaxation unseen;
  const auto result = relax(*model.system, *solver, options, q, unseen);
  EXPECT_EQ(result.end, RelaxationEnd::converged) << result.diagnosis;
  return q;
}

/// Holds the derivatives of a case's equilibrium against differences of equilibria.
void expect_derivatives_of_equilibrium(const std::string& text, const std::string& keys) {
  const Case c = parse_case(text + "\n[sensitivity]\nparameters = [" + keys + "]\n", "CASE.toml");
  const auto model = build_model(c);
  const Vector q = relaxed(model, c, model.initial), still = Vector::Zero(q.size());
  Sensitivities sensitivities(c, model);
  const auto found = sensitivities.at_equilibrium({0, q, still});
  ASSERT_EQ(found.size(), c.sensitivities.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto& p = c.sensitivities[k];
    const auto at = [&](double factor) {
      const Case changed = with_parameter(c, p, factor * p.value);
      const auto other = build_model(changed);
      return other.of_nodes(relaxed(other, changed, q));
    };
    const Vector expected = (at(1 + change) - at(1 - change)) / (2 * change * p.value);
    EXPECT_GT(expected.norm(), 0);
    EXPECT_LT((found[k].position - expected).lpNorm<Eigen::Infinity>(), agreement * expected.lpNorm<Eigen::Infinity>())
        << p.key;
  }
}

std::string strip(const std::string& more, const std::string& model = "particle") {
  return "model = \"" + model + R"("
analysis = "relaxation"
[cloth]
shape = "rectangle"
size = ["10 cm", "1 cm"]
cells = [20, 1]
waviness = { amplitude = 0 }
[material]
thickness = "0.5 mm"
weight = "0.025 gf/cm^2"
youngs_modulus = "2 MPa"
poisson = 0.2
bending = { law = "linear", rigidity = "0.3 gf*cm^2/cm" }
[[load]]
kind = "gravity"
acceleration = [0, 0, -9.80665]
)" + more;
}

TEST(StaticSensitivity, OfACantilever) {
  for (const char* model : {"particle", "shell"})
    expect_derivatives_of_equilibrium(strip("[[fix]]\nnodes = \"left\"\n", model),
                                      R"("material.bending.rigidity", "material.weight", "load.0.acceleration.2")");
}

TEST(StaticSensitivity, OfACatenary) {
  expect_derivatives_of_equilibrium(strip("[[fix]]\nnodes = \"left\"\ncomponents = [\"x\", \"y\", \"z\"]\n"
                                          "[[fix]]\nnodes = \"right\"\ncomponents = [\"x\", \"y\", \"z\"]\n"),
                                    R"("material.youngs_modulus", "material.weight", "material.bending.rigidity")");
}

TEST(StaticSensitivity, OfAStripOverTheEdgeOfATable) {
  expect_derivatives_of_equilibrium(
      strip(R"(
[[fix]]
nodes = "left"
components = ["x", "y", "z"]
[[obstacle]]
kind = "box"
size = ["20 cm", "20 cm", "4 cm"]
edge_radius = "3 mm"
place = { translate = ["-9.2 cm", 0, "-2 cm"] }
[contact]
stiffness = "1e7 N/m^3"
)"),
      R"("material.bending.rigidity", "material.weight", "contact.stiffness", "obstacle.0.edge_radius")");
}

TEST(StaticSensitivity, OfAMeasuredBendingLawWithoutEnergy) {
  const std::string linear = "law = \"linear\", rigidity = \"0.3 gf*cm^2/cm\"";
  auto text = strip("[[fix]]\nnodes = \"left\"\n", "shell");
  text.replace(text.find(linear), linear.size(),
               "law = \"polynomial\", coefficients = [1.33387, -2.2307, 2.3651, -1.08471, 0.17876], curvature_unit = "
               "\"1/cm\", moment_unit = \"gf*cm/cm\", max_curvature = \"2.5 1/cm\", form = \"paper\"");
  expect_derivatives_of_equilibrium(text, R"("material.bending.coefficients.0", "material.bending.coefficients.1")");
}

TEST(StaticSensitivity, OfWhereASupportIs) {
  // The free end of a hanging strip follows its support: dx/dx₀ = 1 for every node.
  const auto text = strip("place_holder");
  auto moved = text;
  moved.replace(moved.find("waviness"), 8, "place = { translate = [\"2 cm\", 0, 0] }\nwaviness");
  moved.replace(moved.find("place_holder"), 12, "[[fix]]\nnodes = \"left\"\n");
  const Case c = parse_case(moved + "\n[sensitivity]\nparameters = [\"cloth.place.translate.0\"]\n", "CASE.toml");
  const auto model = build_model(c);
  const Vector q = relaxed(model, c, model.initial);
  Sensitivities sensitivities(c, model);
  const auto found = sensitivities.at_equilibrium({0, q, Vector::Zero(q.size())});
  ASSERT_EQ(found.size(), 1U);
  for (int n = 0; n < model.mesh.nodes(); ++n) {
    EXPECT_NEAR(found[0].position[3 * n], 1, agreement);
    EXPECT_NEAR(found[0].position[3 * n + 2], 0, agreement);
  }
}

TEST(StaticSensitivity, RefusesWhatIsNoContinuousNumber) {
  const auto problem = [](const std::string& key) -> std::string {
    try {
      const Case c = parse_case(
          strip("[[fix]]\nnodes = \"left\"\n") + "[sensitivity]\nparameters = [\"" + key + "\"]\n", "CASE.toml");
      const auto model = build_model(c);
      Sensitivities sensitivities(c, model);
      return "none";
    } catch (const CaseError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(problem("cloth.cells.0"),
            "CASE.toml:20: sensitivity.parameters: 'cloth.cells.0': 'cloth.cells' is a whole number, which has no "
            "derivative");
  EXPECT_EQ(problem("material.bending.rigidty"),
            "CASE.toml:20: sensitivity.parameters: 'material.bending.rigidty': there is no key "
            "'material.bending.rigidty', did you mean 'rigidity'?");
  EXPECT_EQ(problem("obstacle.0.friction"),
            "CASE.toml:20: sensitivity.parameters: 'obstacle.0.friction': 'obstacle' has no entry '0'");
  EXPECT_NE(problem("contact.stiffness").find("give it a value"), std::string::npos);
  EXPECT_NE(problem("material.damping.mass").find("is 0"), std::string::npos);
  EXPECT_NE(problem("material.net.compression_factor").find("at the edge of"), std::string::npos);
  EXPECT_NE(problem("load.0.kind").find("is not a number"), std::string::npos);
}

}  // namespace
}  // namespace sundrape

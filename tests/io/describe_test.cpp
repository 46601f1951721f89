#include <regex>

#include <gtest/gtest.h>

#include "sundrape/io/case_reader.hpp"

#include "case_samples.hpp"

namespace sundrape {
namespace {

TEST(CaseDescription, PrintsSiValuesWithTheirUnits) {
  const std::string text = describe(parse_case(sample_case(), "c.toml"));
  const auto line_of = [&](const std::string& key) {
    const auto begin = text.find("\n" + key + " ") + 1;
    return begin == 0 ? "no " + key : text.substr(begin, text.find('\n', begin) - begin);
  };
  const auto ends_with = [&](const std::string& key, const std::string& value) {
    EXPECT_TRUE(line_of(key).ends_with(" = " + value)) << line_of(key);
  };
  ends_with("material.thickness", "0.00054229 m");
  ends_with("cloth.size", "[0.2, 0.2] m");
  ends_with("material.density_area", "0.2384 kg/m^2");
  ends_with("fix.0.nodes", "{ near = [0, 0, 0] m }");
  ends_with("fix.0.components", R"(["x", "y"])");
  ends_with("load.0.acceleration", "[0, 0, -9.80665] m/s^2");
  ends_with("obstacle.0.place.translate", "[0, 0, -0.04] m");
  ends_with("contact.stiffness", "(from the load and `penetration`)");
  ends_with("dynamics.duration", "0.2 s");
  ends_with("output.frames", "10 (11 with the one at 0 s)");
  // E h of 118.1176 gf/mm² and 0.54229 mm: 64.054... gf/mm
  EXPECT_NEAR(std::stod(line_of("membrane stiffness, warp").substr(line_of("membrane stiffness, warp").find('=') + 1)),
              118.1176 * 0.54229 * 9.80665e-3 * 1e3, 1e-6);
}

TEST(CaseDescription, PrintsTheElementsAndTheBendingLawOfAShell) {
  const std::string law =
      "bending = { law = \"polynomial\", coefficients = [1, 0.5], curvature_unit = \"1/m\", moment_unit = \"N\", "
      "max_curvature = 3 }\npoisson";
  std::string text = describe(
      parse_case(sample_with("poisson", law), "c.toml", {"model=shell", R"(fix.0.components=["x", "director-x"])"}));
  text = std::regex_replace(text, std::regex(" +"), " ");
  for (const auto* line : {"model = \"shell\"", "shell.membrane = \"centre\"",
                           "shell.hourglass_factor = (0.1, and 1 in elements that span the sheet from edge to edge)",
                           "shell.shear_correction = 0.8333333333", "material.bending.law = \"polynomial\"",
                           "material.bending.coefficients = [[1, 0.5], [1, 0.5]] of N over powers of 1/m",
                           "material.bending.max_curvature = [3, 3] 1/m", R"(fix.0.components = ["x", "director-x"])",
                           "output.resultants = true", "bending rigidity, warp at K = 0 = 1.098901099 N m"})
    EXPECT_NE(text.find("\n" + std::string(line) + "\n"), std::string::npos) << line << " in\n" << text;
  EXPECT_EQ(text.find("material.net"), std::string::npos);
  const std::string net = describe(parse_case(sample_case(), "c.toml"));
  EXPECT_EQ(net.find("shell."), std::string::npos);
  EXPECT_EQ(net.find("resultants"), std::string::npos);
}

TEST(CaseDescription, CoversEveryKindOfEntry) {
  const std::string text = describe(parse_case(full_case(), "c.toml"));
  for (const auto* key :
       {"cloth.waviness.seed", "cloth.place.rotate.angle", "fix.1.name", "load.4.value", "load.3.per_length",
        "obstacle.2.axis", "obstacle.5.height", "contact.restitution_speed", "output.probes.0.near"})
    EXPECT_NE(text.find(std::string("\n") + key + " "), std::string::npos) << key << " in\n" << text;
  const std::string relaxed = describe(parse_case(full_case(), "c.toml", {"analysis=relaxation"}));
  EXPECT_NE(relaxed.find("\nrelaxation.c_disp "), std::string::npos);
  EXPECT_EQ(relaxed.find("\ndynamics."), std::string::npos);
}

}  // namespace
}  // namespace sundrape

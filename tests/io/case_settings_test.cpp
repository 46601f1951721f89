#include <gtest/gtest.h>

#include "sundrape/io/case_reader.hpp"

#include "case_samples.hpp"

namespace sundrape {
namespace {

Case with_sets(const std::vector<std::string>& sets, const std::string& text = sample_case()) {
  return parse_case(text, "CASE.toml", sets);
}

std::string complaint(const std::string& set) {
  try {
    (void)with_sets({set});
    return "accepted";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.line(), 0);
    return error.what();
  }
}

TEST(Settings, ReplaceWhatTheFileSays) {
  const Case c = with_sets({"cloth.cells=[12, 14]", "material.thickness=0.6 mm", "dynamics.duration=\"50 ms\"",
                            "dynamics.rtol=1e-5", "dynamics.integrator=ida", "title=A sheet, \"renamed\""});
  const auto& sheet = std::get<RectangleShape>(c.sheet().cloth.shape);
  EXPECT_EQ(sheet.cells_warp, 12);
  EXPECT_EQ(sheet.cells_weft, 14);
  EXPECT_DOUBLE_EQ(c.sheet().fabric.thickness, 0.0006);
  EXPECT_DOUBLE_EQ(c.dynamics.duration, 0.05);
  EXPECT_EQ(c.dynamics.rtol, 1e-5);
  EXPECT_EQ(c.dynamics.integrator, IntegratorKind::ida);
  EXPECT_EQ(c.title, "A sheet, \"renamed\"");
}

TEST(Settings, AddTablesAndKeysThatTheFileLacks) {
  const Case c = with_sets({"material.damping.membrane=2 ms", "arc-length.tolerance=1e-5", "contact.restitution=0.5",
                            "material.bending.rigidity=0.589 gf*cm^2/cm"});
  EXPECT_DOUBLE_EQ(c.sheet().fabric.damping.membrane, 0.002);
  EXPECT_DOUBLE_EQ(c.sheet().fabric.damping.bending, 3e-4);
  EXPECT_EQ(c.contact.restitution, 0.5);
  EXPECT_NEAR(c.sheet().fabric.warp_bending, 0.589 * 9.80665e-5 / (1 - 0.3 * 0.3), 1e-18);
}

TEST(Settings, ReachIntoArraysByIndex) {
  const Case c = with_sets({"load.0.acceleration=[0, 0, -1]", "obstacle.0.size.2=9 cm", "output.probes.0.name=tip"});
  EXPECT_EQ(std::get<GravityLoad>(c.loads.at(0).load).acceleration, Vector3(0, 0, -1));
  EXPECT_DOUBLE_EQ(std::get<BoxShape>(c.obstacles.at(0).shape).size.z(), 0.09);
  EXPECT_EQ(c.output.probes.at(0).name, "tip");
}

TEST(Settings, ReachTheOnlyPieceOfCloth) {
  const Case c = with_sets({"cloth.cells=[3, 4]"}, sample_with("[cloth]", "[[cloth]]\nname = \"only\""));
  EXPECT_EQ(std::get<RectangleShape>(c.sheet().cloth.shape).cells_weft, 4);
}

TEST(Settings, LaterOnesWin) { EXPECT_EQ(with_sets({"dynamics.rtol=1e-5", "dynamics.rtol=1e-6"}).dynamics.rtol, 1e-6); }

TEST(Settings, AreNamedWhenTheyAreWrong) {
  EXPECT_EQ(complaint("material.poison=0.3"),
            "--set material.poison=0.3: material.poison: unknown key, did you mean 'poisson'?");
  EXPECT_EQ(complaint("material.poisson=0.7"), "--set material.poisson=0.7: material.poisson: 0.7 is outside [0, 0.5)");
  EXPECT_EQ(complaint("material.thickness=0.6 kg"),
            "--set material.thickness=0.6 kg: material.thickness: '0.6 kg' is a mass, a length is expected");
  EXPECT_EQ(complaint("obstacle.0.friction=-0.2"),
            "--set obstacle.0.friction=-0.2: obstacle.0.friction: -0.2 is outside [0, inf)");
  EXPECT_EQ(complaint("materials.poisson=0.3"),
            "--set materials.poisson=0.3: materials: unknown key, did you mean 'material'?");
  EXPECT_EQ(complaint("material.bending.law=linear"),
            "--set material.bending.law=linear: material.bending.rigidity: missing: Moment per width and curvature of "
            "a strip, or `[warp, weft]` of it, e.g. `\"0.589 gf*cm^2/cm\"`.");
}

TEST(Settings, ThatLeadNowhereAreRefused) {
  EXPECT_EQ(complaint("dynamics.rtol"), "--set dynamics.rtol: KEY.PATH=VALUE is expected");
  EXPECT_EQ(complaint("=3"), "--set =3: KEY.PATH=VALUE is expected");
  EXPECT_EQ(complaint("dynamics..rtol=1"), "--set dynamics..rtol=1: dynamics..rtol: a part of the key is empty");
  EXPECT_EQ(complaint("load.3.ramp=1 s"), "--set load.3.ramp=1 s: load.3.ramp: '3' is not an index from 0 to 0");
  EXPECT_EQ(complaint("load.kind=force"), "--set load.kind=force: load.kind: 'kind' is not an index from 0 to 0");
  EXPECT_EQ(complaint("title.x=1"), "--set title.x=1: title.x: 'title' is neither a table nor an array");
  std::string text = sample_case();
  text.erase(text.find("[[load]]"), text.find("[[obstacle]]") - text.find("[[load]]"));
  try {
    (void)with_sets({"load.0.ramp=1 s"}, text);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.message(), "the case has no [[load]]");
  }
}

TEST(Settings, AreInTheTextOfTheCase) {
  const Case once = with_sets({"dynamics.rtol=1e-5", "material.thickness=0.6 mm", "load.0.acceleration=[0, 0, -1.6]"});
  const Case again = parse_case(once.text, "CASE.toml");
  EXPECT_EQ(again.dynamics.rtol, 1e-5);
  EXPECT_EQ(again.text, once.text);
  EXPECT_EQ(describe(again), describe(once));
}

}  // namespace
}  // namespace sundrape

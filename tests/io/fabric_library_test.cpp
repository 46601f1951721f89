#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "sundrape/io/case_reader.hpp"

#include "case_samples.hpp"

namespace sundrape {
namespace {

constexpr double gf = 9.80665e-3;  // [N]

/// Cases in a folder of their own, with fabrics beside them.
class FabricLibrary : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("fabrics_") + test->name());
    std::filesystem::create_directories(folder_ / "fabrics");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  /// The sample with this material, read as a file of the folder.
  [[nodiscard]] Case read(const std::string& material, const std::vector<std::string>& sets = {}) const {
    return parse_case(with_material(material + "\n"), folder_ / "CASE.toml", sets);
  }
  [[nodiscard]] Fabric fabric(const std::string& material, const std::vector<std::string>& sets = {}) const {
    return read(material, sets).sheet().fabric;
  }

  struct Complaint {
    std::string file, key, message;
    int line = -1;
  };
  [[nodiscard]] Complaint complaint(const std::string& material, const std::vector<std::string>& sets = {}) const {
    try {
      (void)read(material, sets);
      return {};
    } catch (const CaseError& error) {
      return {error.file(), error.key(), error.message(), error.line()};
    }
  }

  std::filesystem::path folder_;
};

const std::string orthotropic =
    "thickness = \"0.5 mm\"\nweight = \"0.02 gf/cm^2\"\nwarp_modulus = 2e6\nweft_modulus = 1e6\nshear_modulus = 3e4\n"
    "poisson = [0.2]\nbending = { rigidity = [4e-6, 2e-6] }\ndamping = { mass = 3, bending = 7e-3 }\n"
    "net = { shear_factor = 2 }\n";

TEST_F(FabricLibrary, HasTheFabricsOfThePapers) {
  // thickness, weight and bending of a strip as in the papers, with E h³/12 where bending is not measured apart
  struct Row {
    const char* name;
    double thickness, weight, strip, poisson;  // cm, gf/cm², gf cm²/cm, 1
  };
  for (const Row& row :
       {Row{"cotton-twill", 0.0489, 0.02665, 0.589, 0.3},
        Row{"tablecloth-cotton", 0.054229, 0.0238385, 11811.6 * std::pow(0.054229, 3) / 12, 0.3},
        Row{"polyester-plain-weave", 0.0469, 0.0176602, 18438 * std::pow(0.0469, 3) / 12, 0},
        Row{"overhang-strip", 0.0406, 0.0255, 0.386, 0}, Row{"polyester-faille", 0.0226, 0.01043, 0.019, 0},
        Row{"wool-tropical", 0.0407, 0.01629, 0.067, 0}, Row{"cotton-broadcloth", 0.0497, 0.01238, 0.118, 0}}) {
    const Fabric f = fabric("fabric = \"" + std::string(row.name) + '"');
    // the digits of the table, in which lengths are rounded to five and count three times
    EXPECT_NEAR(f.thickness, row.thickness * 1e-2, 1e-5 * f.thickness) << row.name;
    EXPECT_NEAR(f.area_density * 9.80665, row.weight * gf * 1e4, 1e-5 * row.weight * gf * 1e4) << row.name;
    EXPECT_NEAR(f.warp_bending * (1 - row.poisson * row.poisson), row.strip * gf * 1e-2, 1e-4 * row.strip * gf * 1e-2)
        << row.name;
    EXPECT_EQ(f.poisson, row.poisson) << row.name;
    // membrane and bending belong to one thickness: E = 12 B/h³
    EXPECT_NEAR(f.warp_membrane * f.thickness * f.thickness / 12, row.strip * gf * 1e-2, 2e-3 * row.strip * gf * 1e-2)
        << row.name;
  }
  EXPECT_EQ(read("fabric = \"cotton-twill\"").sheet().fabric_title, "Cotton twill, linear bending");
}

TEST_F(FabricLibrary, HasThePolynomialOfTheTwill) {
  const Fabric f = fabric("fabric = \"cotton-twill-polynomial\"");
  ASSERT_TRUE(f.measured_bending.has_value());
  EXPECT_NEAR(f.measured_bending->warp.at(100.0).moment, 0.56232 * gf, 1e-12);  // the sum of its coefficients
  EXPECT_DOUBLE_EQ(f.measured_bending->warp.max_curvature(), 250);
}

TEST_F(FabricLibrary, PutsKeysBesideTheFabricInThePlaceOfItsOwn) {
  write("fabrics/weave.toml", orthotropic);
  const Fabric plain = fabric("fabric = \"weave\"");
  EXPECT_DOUBLE_EQ(plain.thickness, 5e-4);
  EXPECT_DOUBLE_EQ(plain.poisson, 0.2);
  EXPECT_DOUBLE_EQ(plain.damping.mass, 3);
  EXPECT_DOUBLE_EQ(plain.damping.membrane, 1e-3);
  EXPECT_EQ(plain.net.shear_factor, 2);

  const Fabric other = fabric(
      "fabric = \"weave\"\nthickness = \"1 mm\"\npoisson = 0\ndamping = { mass = 0 }\nnet = { compression_factor = 0.5 "
      "}");
  EXPECT_DOUBLE_EQ(other.thickness, 1e-3);
  EXPECT_EQ(other.poisson, 0);
  EXPECT_DOUBLE_EQ(other.warp_membrane, 2e6 * 1e-3);
  EXPECT_DOUBLE_EQ(other.warp_bending, 4e-6);
  // damping and net are merged key by key
  EXPECT_EQ(other.damping.mass, 0);
  EXPECT_DOUBLE_EQ(other.damping.bending, 7e-3);
  EXPECT_EQ(other.net.compression_factor, 0.5);
  EXPECT_EQ(other.net.shear_factor, 2);
}

TEST_F(FabricLibrary, ReplacesBendingAsAWhole) {
  write("fabrics/weave.toml", orthotropic);
  const Fabric f = fabric(
      "fabric = \"weave\"\nbending = { law = \"polynomial\", coefficients = [1e-6], curvature_unit = \"1/m\", "
      "moment_unit = \"N\", max_curvature = 100 }",
      {"model=shell"});
  EXPECT_TRUE(f.measured_bending.has_value());
}

TEST_F(FabricLibrary, KeepsTheLawOfBendingWhereOnlyItsFormIsGiven) {
  for (const Fabric& f : {fabric("fabric = \"cotton-twill-polynomial\"\nbending = { form = \"paper\" }"),
                          fabric("fabric = \"cotton-twill-polynomial\"", {"material.bending.form=paper"})}) {
    ASSERT_TRUE(f.measured_bending.has_value());
    EXPECT_EQ(f.measured_bending->form, PlateBending::Form::paper);
    EXPECT_DOUBLE_EQ(f.measured_bending->warp.max_curvature(), 250);
  }
}

TEST_F(FabricLibrary, LetsOneAlternativeReplaceTheOthers) {
  write("fabrics/weave.toml", orthotropic);
  EXPECT_DOUBLE_EQ(fabric("fabric = \"weave\"\ndensity_area = 0.3").area_density, 0.3);
  EXPECT_DOUBLE_EQ(fabric("fabric = \"weave\"\ndensity = 400").area_density, 0.2);
  const Fabric isotropic = fabric("fabric = \"weave\"\nyoungs_modulus = 5e6");
  EXPECT_DOUBLE_EQ(isotropic.warp_membrane, 2500);
  EXPECT_DOUBLE_EQ(isotropic.weft_membrane, 2500);
  // one modulus of three leaves the other two
  EXPECT_DOUBLE_EQ(fabric("fabric = \"weave\"\nweft_modulus = 1.5e6").weft_membrane, 750);
  EXPECT_DOUBLE_EQ(fabric("fabric = \"weave\"\nweft_modulus = 1.5e6").warp_membrane, 1000);
  const Fabric threads =
      fabric("fabric = \"cotton-twill\"\nwarp_modulus = 2e6\nweft_modulus = 1e6\nshear_modulus = 1e4");
  EXPECT_DOUBLE_EQ(threads.warp_membrane, 2e6 * 0.489e-3);
  EXPECT_EQ(complaint("fabric = \"cotton-twill\"\nwarp_modulus = 2e6").key, "material.weft_modulus");
}

TEST_F(FabricLibrary, IsOpenToSettings) {
  const std::string twill = "fabric = \"cotton-twill\"";
  EXPECT_EQ(fabric(twill, {"material.poisson=0"}).poisson, 0);
  EXPECT_DOUBLE_EQ(fabric(twill, {"material.damping.mass=2 1/s"}).damping.mass, 2);
  EXPECT_DOUBLE_EQ(fabric(twill, {"material.bending.rigidity=1e-5", "material.poisson=0"}).warp_bending, 1e-5);
  // another fabric in the place of the file's, whose overrides stay
  const Fabric other = fabric(twill + "\npoisson = 0.1", {"material.fabric=overhang-strip"});
  EXPECT_DOUBLE_EQ(other.thickness, 0.406e-3);
  EXPECT_EQ(other.poisson, 0.1);
}

TEST_F(FabricLibrary, ReplacesAMaterialThatIsSpeltOut) {
  const std::string spelt =
      "thickness = 1e-3\ndensity = 300\npoisson = 0.1\nyoungs_modulus = 1e6\nbending = { rigidity = "
      "1e-5 }\ndamping = { mass = 2 }";
  const Fabric f = fabric(spelt, {"material.fabric=tablecloth-cotton", "material.thickness=2 mm"});
  EXPECT_DOUBLE_EQ(f.thickness, 2e-3);  // a setting as well
  EXPECT_EQ(f.poisson, 0.3);
  EXPECT_NEAR(f.area_density, 0.238385, 1e-6);
  EXPECT_NEAR(f.warp_bending, 11811.6 * gf * 1e4 * 8e-9 / 12 / 0.91, 1e-5 * f.warp_bending);  // no trace of 1e-5 N m
  EXPECT_DOUBLE_EQ(f.damping.mass, 2);  // how a case is damped is not its fabric
}

TEST_F(FabricLibrary, LooksBesideTheCaseFirst) {
  write("fabrics/cotton-twill.toml", orthotropic);
  EXPECT_DOUBLE_EQ(fabric("fabric = \"cotton-twill\"").thickness, 5e-4);
  write("mine.toml", orthotropic);
  EXPECT_DOUBLE_EQ(fabric("fabric = \"mine.toml\"").thickness, 5e-4);
  EXPECT_EQ(read("fabric = \"mine.toml\"").sheet().fabric_title, "mine.toml");
  EXPECT_DOUBLE_EQ(fabric("fabric = \"./fabrics/../mine.toml\"").thickness, 5e-4);
}

TEST_F(FabricLibrary, NamesWhatIsThereWhereAFabricIsNot) {
  write("fabrics/weave.toml", orthotropic);
  const auto unknown = complaint("fabric = \"coton-twill\"");
  EXPECT_EQ(unknown.file, (folder_ / "CASE.toml").string());
  EXPECT_EQ(unknown.line, 12);
  EXPECT_EQ(unknown.key, "material.fabric");
  EXPECT_EQ(unknown.message,
            "there is no fabric 'coton-twill'; did you mean 'cotton-twill'? available: "
            "cotton-broadcloth, cotton-twill, cotton-twill-polynomial, overhang-strip, polyester-faille, "
            "polyester-plain-weave, tablecloth-cotton, weave, wool-tropical");
  EXPECT_EQ(complaint("fabric = \"none.toml\"").message, "'none.toml' is not there (sought beside the case file)");
  EXPECT_EQ(complaint("fabric = 3").message, "a string is expected, not 3");
  EXPECT_NE(complaint("fabric = \"\"").message.find("there is no fabric ''"), std::string::npos);
  const auto set = complaint("fabric = \"weave\"", {"material.fabric=silk"});
  EXPECT_EQ(set.file, "--set material.fabric=silk");
  EXPECT_EQ(set.line, 0);
}

TEST_F(FabricLibrary, PointsIntoTheFabricsFileWhereThatIsWrong) {
  const auto wrong = [&](const std::string& text) {
    write("fabrics/weave.toml", text);
    auto c = complaint("fabric = \"weave\"");
    EXPECT_EQ(c.file, (folder_ / "fabrics" / "weave.toml").string()) << c.message;
    return c;
  };
  const auto range = wrong("thickness = 1\ndensity = 1\nyoungs_modulus = 1\n\npoisson = 0.7\n");
  EXPECT_EQ(range.line, 5);
  EXPECT_EQ(range.key, "material.poisson");
  EXPECT_EQ(range.message, "0.7 is outside [0, 0.5)");
  const auto unknown = wrong("thickness = 1\nthicknes = 1\n");
  EXPECT_EQ(unknown.line, 2);
  EXPECT_EQ(unknown.message, "unknown key, did you mean 'thickness'?");
  const auto inner = wrong("thickness = 1\n[damping]\nmas = 1\n");
  EXPECT_EQ(inner.line, 3);
  EXPECT_EQ(inner.key, "material.damping.mas");
  const auto falling = wrong(
      "thickness = 1e-3\ndensity = 300\nyoungs_modulus = 1e6\n[bending]\nlaw = \"polynomial\"\ncoefficients = [1, -1]\n"
      "curvature_unit = \"1/m\"\nmoment_unit = \"N\"\nmax_curvature = 2\n");
  EXPECT_EQ(falling.line, 6);
  EXPECT_EQ(falling.key, "material.bending.coefficients");
  EXPECT_EQ(wrong("thickness = \n").line, 1);
  EXPECT_EQ(wrong("fabric = \"cotton-twill\"\n").message, "a fabric cannot name another one");
  // what it lacks is missing in the case
  write("fabrics/weave.toml", "density = 1\nyoungs_modulus = 1\n");
  const auto lacking = complaint("fabric = \"weave\"");
  EXPECT_EQ(lacking.file, (folder_ / "CASE.toml").string());
  EXPECT_EQ(lacking.key, "material.thickness");
}

TEST_F(FabricLibrary, LeavesATextThatStandsOnItsOwn) {
  write("fabrics/weave.toml", orthotropic);
  const Case once = read("fabric = \"weave\"\npoisson = 0.1", {"material.thickness=0.6 mm"});
  std::filesystem::remove(folder_ / "fabrics" / "weave.toml");
  const Case again = parse_case(once.text, "elsewhere/CASE.toml");
  EXPECT_EQ(again.text, once.text);
  EXPECT_EQ(describe(again), describe(once));
  EXPECT_EQ(again.sheet().fabric_title, "weave");
  EXPECT_EQ(once.text.find("fabric ="), std::string::npos);
}

TEST_F(FabricLibrary, IsInTheDescription) {
  const std::string text = describe(read("fabric = \"cotton-twill\""));
  EXPECT_NE(text.find("\"Cotton twill, linear bending\""), std::string::npos) << text;
  EXPECT_NE(text.find("0.000489 m"), std::string::npos) << text;
}

}  // namespace
}  // namespace sundrape

#include "sundrape/io/case_reader.hpp"

#include <fstream>
#include <numbers>
#include <system_error>

#include <gtest/gtest.h>

#include "case_samples.hpp"

namespace sundrape {
namespace {

constexpr double gf = 9.80665e-3;  // [N]

Case full() { return parse_case(full_case(), "cases/full.toml"); }

void expect_close(double value, double expected) { EXPECT_NEAR(value, expected, 1e-12 * std::abs(expected)); }

TEST(CaseReader, ResolvesTheSheetToSi) {
  const Case c = full();
  EXPECT_EQ(c.title, "Tablecloth on a square table");
  EXPECT_EQ(c.analysis, Analysis::dynamics);
  const auto& sheet = std::get<RectangleShape>(c.sheet().cloth.shape);
  expect_close(sheet.length, 0.2);
  expect_close(sheet.width, 0.3);
  EXPECT_EQ(sheet.cells_warp, 20);
  EXPECT_EQ(sheet.cells_weft, 24);
  EXPECT_LT((c.sheet().cloth.place.translate - Vector3(0, 0, 1e-3)).norm(), 1e-15);
  EXPECT_EQ(c.sheet().cloth.place.axis, Vector3::UnitZ());
  expect_close(c.sheet().cloth.place.angle, std::numbers::pi / 4);
  EXPECT_EQ(c.sheet().cloth.waviness_given, true);
  expect_close(c.sheet().cloth.waviness_amplitude, 2.54e-6);
  EXPECT_EQ(c.sheet().cloth.waviness_seed, 7U);
}

TEST(CaseReader, ResolvesTheFabricToResultants) {
  const Fabric fabric = full().sheet().fabric;
  const double h = 0.54229e-3;
  const double youngs_modulus = 118.1176 * gf * 1e6;
  expect_close(fabric.thickness, h);
  expect_close(fabric.area_density, 0.2384);  // 0.2384e-3 gf/mm² weighs what 0.2384 kg/m² do
  expect_close(fabric.warp_membrane, youngs_modulus * h);
  expect_close(fabric.shear_membrane, youngs_modulus * h / 2.6);
  // B of strips over 1 − ν₁₂ ν₂₁, ν₂₁ = ν₁₂ B₂/B₁
  const double product = 0.3 * 0.3 * 0.4 / 0.589;
  expect_close(fabric.warp_bending, 0.589 * gf * 1e-2 / (1 - product));
  expect_close(fabric.weft_bending, 0.4 * gf * 1e-2 / (1 - product));
  EXPECT_DOUBLE_EQ(fabric.damping.mass, 0.1);
  EXPECT_DOUBLE_EQ(fabric.damping.membrane, 2e-3);
  EXPECT_DOUBLE_EQ(fabric.damping.bending, 5e-4);
  EXPECT_EQ(fabric.net.compression_factor, 0.5);
  EXPECT_EQ(fabric.net.shear_factor, 2);
  EXPECT_TRUE(fabric.net.diagonal_springs);
  EXPECT_EQ(fabric.net.diagonal_compression_factor, 0.25);
}

TEST(CaseReader, ResolvesSupportsAndNamesThem) {
  const auto fixes = full().fixes;
  ASSERT_EQ(fixes.size(), 3U);
  EXPECT_EQ(std::get<NamedSet>(fixes[0].nodes).name, "left");
  EXPECT_EQ(fixes[0].name, "left");
  EXPECT_EQ(fixes[0].components, (std::array{true, true, true}));
  EXPECT_TRUE(fixes[0].rotation);
  EXPECT_EQ(fixes[1].name, "symmetry");
  EXPECT_EQ(fixes[1].components, (std::array{false, true, false}));
  EXPECT_FALSE(fixes[1].rotation);
  EXPECT_EQ(std::get<OnPlane>(fixes[1].nodes).normal, Vector3::UnitY());
  expect_close(std::get<OnPlane>(fixes[1].nodes).point.y(), 0.01);
  EXPECT_EQ(fixes[2].name, "sphere");
  expect_close(std::get<InSphere>(fixes[2].nodes).radius, 0.02);
}

TEST(CaseReader, KeepsUnnamedSupportsApart) {
  const Case c = parse_case(sample_with("[[load]]", "[[fix]]\nnodes = { near = [1, 0, 0] }\n[[load]]"), "c.toml");
  EXPECT_EQ(c.fixes.at(0).name, "near");
  EXPECT_EQ(c.fixes.at(1).name, "near_2");
}

TEST(CaseReader, ToleratesTheSameSupportTwice) {
  const std::string again = "[[fix]]\nnodes = { near = [0, 0, 0] }\ncomponents = [\"y\", \"x\"]\n[[load]]";
  EXPECT_EQ(parse_case(sample_with("[[load]]", again), "c.toml").fixes.size(), 2U);
}

TEST(CaseReader, ResolvesLoads) {
  const auto loads = full().loads;
  ASSERT_EQ(loads.size(), 5U);
  EXPECT_EQ(std::get<GravityLoad>(loads[0].load).acceleration, Vector3(0, 0, -9.80665));
  EXPECT_EQ(loads[0].ramp, 0);
  expect_close(std::get<ForceLoad>(loads[1].load).total.x(), gf);
  expect_close(loads[1].ramp, 0.1);
  expect_close(std::get<MomentLoad>(loads[2].load).total.y(), gf * 1e-2);
  expect_close(std::get<TractionLoad>(loads[3].load).per_length.y(), gf * 1e2);
  expect_close(std::get<PressureLoad>(loads[4].load).value, 10);
}

TEST(CaseReader, ResolvesObstacles) {
  const auto obstacles = full().obstacles;
  ASSERT_EQ(obstacles.size(), 6U);
  const auto& box = std::get<BoxShape>(obstacles[0].shape);
  EXPECT_LT((box.size - Vector3(0.08, 0.08, 0.04)).norm(), 1e-15);
  expect_close(box.edge_radius, 1e-3);
  expect_close(obstacles[0].place.translate.z(), -0.04);
  EXPECT_EQ(obstacles[0].name, "box0");
  EXPECT_EQ(std::get<PlaneShape>(obstacles[1].shape).point, Vector3(0, 0, -1));
  EXPECT_EQ(std::get<PlaneShape>(obstacles[1].shape).normal, Vector3::UnitZ());
  const auto& cylinder = std::get<CylinderShape>(obstacles[2].shape);
  expect_close(cylinder.radius, 0.025);
  EXPECT_LT((cylinder.axis - Vector3(0, 0.8, 0.6)).norm(), 1e-15);
  EXPECT_EQ(cylinder.edge_radius, 0);
  expect_close(std::get<SphereShape>(obstacles[3].shape).radius, 0.03);
  EXPECT_EQ(obstacles[3].name, "ball");
  expect_close(std::get<CapsuleShape>(obstacles[4].shape).length, 0.05);
  EXPECT_EQ(std::get<CapsuleShape>(obstacles[4].shape).axis, Vector3::UnitZ());
  expect_close(std::get<DiscPedestalShape>(obstacles[5].shape).height, 0.1);
  EXPECT_EQ(obstacles[5].name, "disc5");
}

TEST(CaseReader, ScalesContactByItsThickness) {
  const ContactCase contact = full().contact;
  expect_close(contact.thickness, 5e-4);
  expect_close(contact.smoothing, 5e-5);
  expect_close(contact.penetration, 5e-5);
  expect_close(contact.stiffness.value(), 500 * gf * 1e6);
  EXPECT_EQ(contact.restitution, 0.5);
  // without [contact], the material's thickness
  expect_close(parse_case(sample_case(), "c.toml").contact.smoothing, 0.54229e-4);
}

TEST(CaseReader, ResolvesAnalyses) {
  const Case c = full();
  EXPECT_EQ(c.dynamics.integrator, IntegratorKind::rk4);
  expect_close(c.dynamics.duration, 1);
  EXPECT_EQ(c.dynamics.rtol, 1e-5);
  expect_close(c.dynamics.atol_position.value(), 1e-6);
  expect_close(c.dynamics.atol_velocity.value(), 1e-3);
  EXPECT_EQ(c.dynamics.max_order, 5);
  expect_close(c.dynamics.step.value(), 1e-4);
  expect_close(c.dynamics.max_step.value(), 1e-2);
  expect_close(c.dynamics.first_step.value(), 1e-6);
  EXPECT_EQ(c.dynamics.linear_solver, "cg");
  expect_close(c.dynamics.time_limit.value(), 120);
  EXPECT_EQ(c.relaxation.tolerance, 1e-7);
  EXPECT_EQ(c.relaxation.scheme, "chapter");
  expect_close(c.relaxation.c_disp.value(), 1e-3);
  EXPECT_FALSE(c.relaxation.c_acc.has_value());
}

TEST(CaseReader, FillsInTheDocumentedDefaults) {
  // the table of keys and the initial values of the structs must not drift apart
  const Case c = parse_case(sample_with("rtol = 1e-3", "").replace(0, 1, "t"), "c.toml");
  EXPECT_EQ(c.dynamics.integrator, DynamicsCase{}.integrator);
  EXPECT_EQ(c.dynamics.rtol, DynamicsCase{}.rtol);
  EXPECT_EQ(c.dynamics.max_order, DynamicsCase{}.max_order);
  EXPECT_EQ(c.dynamics.linear_solver, DynamicsCase{}.linear_solver);
  EXPECT_FALSE(c.dynamics.step || c.dynamics.max_step || c.dynamics.first_step || c.dynamics.time_limit);
  EXPECT_EQ(c.relaxation.tolerance, RelaxationCase{}.tolerance);
  EXPECT_EQ(c.relaxation.scheme, RelaxationCase{}.scheme);
  EXPECT_EQ(c.relaxation.max_iterations, RelaxationCase{}.max_iterations);
  EXPECT_EQ(c.relaxation.growth, RelaxationCase{}.growth);
  EXPECT_EQ(c.contact.restitution_speed, ContactCase{}.restitution_speed);
  EXPECT_FALSE(c.contact.restitution || c.contact.stiffness);
  EXPECT_EQ(c.sheet().fabric.damping.mass, Fabric{}.damping.mass);
  EXPECT_DOUBLE_EQ(c.sheet().fabric.damping.membrane, Fabric{}.damping.membrane);
  EXPECT_DOUBLE_EQ(c.sheet().fabric.damping.bending, Fabric{}.damping.bending);
  EXPECT_EQ(c.sheet().fabric.net.compression_factor, Fabric{}.net.compression_factor);
  EXPECT_EQ(c.sheet().fabric.net.shear_factor, Fabric{}.net.shear_factor);
  EXPECT_EQ(c.sheet().fabric.net.diagonal_springs, Fabric{}.net.diagonal_springs);
  EXPECT_EQ(c.sheet().fabric.net.diagonal_compression_factor, Fabric{}.net.diagonal_compression_factor);
  EXPECT_FALSE(c.sheet().cloth.waviness_given.value_or(false));
}

TEST(CaseReader, SpreadsFramesOverTheDuration) {
  const auto ten = parse_case(sample_case(), "c.toml").output.frame_times;
  ASSERT_EQ(ten.size(), 11U);
  EXPECT_EQ(ten.front(), 0);
  EXPECT_DOUBLE_EQ(ten[3], 0.06);
  EXPECT_EQ(ten.back(), 0.2);
  const auto every = full().output.frame_times;  // 0.3 s within 1 s
  ASSERT_EQ(every.size(), 5U);
  EXPECT_DOUBLE_EQ(every[3], 0.9);
  EXPECT_EQ(every[4], 1);
  // 0.2 s is a multiple of 20 ms but for round-off: no second frame at the end
  EXPECT_EQ(parse_case(sample_with("frames = 10", "every = \"20 ms\""), "c.toml").output.frame_times.size(), 11U);
  EXPECT_EQ(parse_case(sample_with("frames = 10", ""), "c.toml").output.frame_times.size(), 61U);
}

TEST(CaseReader, RemembersWhereNodesWereAskedFor) {
  const Case c = parse_case(sample_case(), "CASE.toml");
  EXPECT_EQ(c.fixes.at(0).source.file, "CASE.toml");
  EXPECT_EQ(c.fixes.at(0).source.line, 18);
  EXPECT_EQ(c.fixes.at(0).source.key, "fix.0.nodes");
  EXPECT_EQ(c.loads.at(0).source.line, 21);
  EXPECT_EQ(c.loads.at(0).source.key, "load.0");
  EXPECT_EQ(c.obstacles.at(0).source.line, 25);
  EXPECT_EQ(c.output.probes.at(0).source.line, 37);
  EXPECT_EQ(c.output.probes.at(0).source.key, "output.probes.0.near");
  EXPECT_STREQ(CaseError(c.fixes.at(0).source, "selects no node").what(), "CASE.toml:18: fix.0.nodes: selects no node");
}

TEST(CaseReader, TakesWeightAsMassOrDensityAsWell) {
  const char* const rest = "\nthickness = 1e-3\nyoungs_modulus = 1e6\n";
  for (const auto* weight : {"weight = 1.96133", "density_area = \"200 g/m^2\"", "density = \"0.2 g/cm^3\""})
    expect_close(parse_case(with_material(std::string(weight) + rest), "c.toml").sheet().fabric.area_density, 0.2);
}

TEST(CaseReader, TakesWarpAndWeftApart) {
  const Fabric fabric = parse_case(with_material("thickness = 1e-3\ndensity_area = 0.2\nwarp_modulus = 2e6\n"
                                                 "weft_modulus = 1e6\nshear_modulus = 3e4\npoisson = [0.4]\n"),
                                   "c.toml")
                            .sheet()
                            .fabric;
  expect_close(fabric.warp_membrane, 2000);
  expect_close(fabric.weft_membrane, 1000);
  expect_close(fabric.shear_membrane, 30);
  // ν₁₂ ν₂₁ = 0.4 · 0.4 · 1/2 = 0.08
  expect_close(fabric.warp_bending, 2e6 * 1e-9 / 12 / 0.92);
  expect_close(fabric.weft_bending, 1e6 * 1e-9 / 12 / 0.92);
  expect_close(fabric.bending_coupling, 0.4 * fabric.weft_bending);
  expect_close(fabric.twist_bending, 3e4 * 1e-9 / 12);
  expect_close(fabric.transverse_shear, std::sqrt(2e6 * 1e6) * 1e-3 / (2 * (1 + std::sqrt(0.08))));
}

TEST(CaseReader, TakesAMeasuredTwist) {
  const Fabric fabric = parse_case(sample_with("poisson",
                                               "bending = { rigidity = \"0.5 gf*cm\", twist_rigidity = "
                                               "\"0.1 gf*cm\" }\npoisson"),
                                   "c.toml")
                            .sheet()
                            .fabric;
  expect_close(fabric.warp_bending, 0.5e-2 * gf / 0.91);
  expect_close(fabric.bending_coupling, 0.3 * 0.5e-2 * gf / 0.91);
  expect_close(fabric.twist_bending, 0.1e-2 * gf);
  EXPECT_FALSE(fabric.measured_bending.has_value());
}

/// The twill's bending test as the article prints it, with one more key.
std::string twill_bending(const std::string& more = "") {
  return "bending = { law = \"polynomial\", coefficients = [1.33387, -2.2307, 2.3651, -1.08471, 0.17876], "
         "curvature_unit = \"1/cm\", moment_unit = \"gf*cm/cm\", max_curvature = \"2.5 1/cm\"" +
         more + " }\npoisson";
}

TEST(CaseReader, TurnsAPolynomialOfTheTextileTradeToSi) {
  const Fabric fabric = parse_case(sample_with("poisson", twill_bending()), "c.toml", {"model=shell"}).sheet().fabric;
  ASSERT_TRUE(fabric.measured_bending.has_value());
  const auto& bending = *fabric.measured_bending;
  EXPECT_EQ(bending.form, PlateBending::Form::energy);
  // at K = 1 /cm: the sum of the coefficients, 0.56232 gf cm/cm; past 2.5 /cm the slope stays
  EXPECT_NEAR(bending.warp.at(100.0).moment, 0.56232 * gf, 1e-12);
  EXPECT_DOUBLE_EQ(bending.weft.at(100.0).moment, bending.warp.at(100.0).moment);
  EXPECT_DOUBLE_EQ(bending.warp.max_curvature(), 250);
  EXPECT_NEAR(bending.warp.at(55.0).slope, 0.39 * gf * 1e-2, 5e-3 * gf * 1e-2);
  // the rigidities are those at K = 0
  expect_close(fabric.warp_bending, 1.33387 * gf * 1e-2 / 0.91);
  expect_close(fabric.weft_bending, 1.33387 * gf * 1e-2 / 0.91);
  expect_close(fabric.bending_coupling, 0.3 * fabric.warp_bending);
  expect_close(fabric.twist_bending, 0.35 * fabric.warp_bending);
  EXPECT_LT((plate_bending(fabric).rigidity().diagonal() -
             Vector3(fabric.warp_bending, fabric.weft_bending, fabric.twist_bending))
                .norm(),
            1e-15);
}

TEST(CaseReader, TakesPolynomialsOfWarpAndWeftApart) {
  const std::string text =
      "bending = { law = \"polynomial\", coefficients = [[2e-5, 1e-8], [1e-5]], curvature_unit = \"1/m\", moment_unit "
      "= "
      "\"N\", max_curvature = [200, \"3 1/cm\"], form = \"paper\" }\npoisson";
  const Fabric fabric = parse_case(sample_with("poisson", text), "c.toml", {"model=shell"}).sheet().fabric;
  const auto& bending = fabric.measured_bending.value();
  EXPECT_EQ(bending.form, PlateBending::Form::paper);
  EXPECT_DOUBLE_EQ(bending.warp.at(100.0).moment, 2e-3 + 1e-4);
  EXPECT_DOUBLE_EQ(bending.weft.at(100.0).moment, 1e-3);
  EXPECT_DOUBLE_EQ(bending.warp.max_curvature(), 200);
  EXPECT_DOUBLE_EQ(bending.weft.max_curvature(), 300);
  expect_close(fabric.warp_bending, 2e-5 / 0.91);
  expect_close(fabric.weft_bending, 1e-5 / 0.91);
}

TEST(CaseReader, ReadsTheElementsOfAShell) {
  const Case plain = parse_case(sample_case(), "c.toml", {"model=shell"});
  EXPECT_EQ(plain.model, Model::shell);
  EXPECT_EQ(plain.shell.membrane, ShellCase{}.membrane);
  EXPECT_EQ(plain.shell.bending, ShellCase{}.bending);
  EXPECT_EQ(plain.shell.director, ShellCase{}.director);
  EXPECT_EQ(plain.shell.shear_correction, ShellCase{}.shear_correction);
  EXPECT_EQ(plain.shell.rotary_inertia, ShellCase{}.rotary_inertia);
  EXPECT_FALSE(plain.shell.hourglass_factor.has_value());
  EXPECT_TRUE(plain.output.resultants);
  const auto membrane = [](const std::string& name) {
    return parse_case(sample_case(), "c.toml", {"model=shell", "shell.membrane=" + name}).shell.membrane;
  };
  EXPECT_EQ(membrane("centre"), ShellMembrane::centre);
  EXPECT_EQ(membrane("bilinear"), ShellMembrane::bilinear);
  EXPECT_EQ(membrane("edge-tied"), ShellMembrane::edge_tied);
  EXPECT_EQ(membrane("mixed"), ShellMembrane::mixed);
  const Case other = parse_case(
      sample_case(), "c.toml",
      {"model=shell", "shell.hourglass_factor=0.5", "shell.bending=bilinear", "shell.shear_correction=1",
       "shell.director=massless", "shell.rotary_inertia=100", "dynamics.integrator=ida", "output.resultants=false"});
  EXPECT_EQ(other.shell.hourglass_factor, 0.5);
  EXPECT_EQ(other.shell.bending, ShellBending::bilinear);
  EXPECT_EQ(other.shell.shear_correction, 1);
  EXPECT_EQ(other.shell.director, ShellDirector::massless);
  EXPECT_EQ(other.shell.rotary_inertia, 100);
  EXPECT_FALSE(other.output.resultants);
}

TEST(CaseReader, HoldsSingleComponentsOfADirector) {
  const auto fix = [](const std::string& components) {
    return parse_case(sample_with(R"(["x", "y"])", components), "c.toml", {"model=shell"}).fixes.at(0);
  };
  const auto symmetry = fix(R"(["x", "director-x"])");
  EXPECT_EQ(symmetry.components, (std::array{true, false, false}));
  EXPECT_EQ(symmetry.director, (std::array{true, false, false}));
  EXPECT_FALSE(symmetry.rotation);
  const auto clamped = fix(R"(["rotation", "director-z"])");
  EXPECT_EQ(clamped.director, (std::array{true, true, true}));
  EXPECT_TRUE(clamped.rotation);
  EXPECT_EQ(fix(R"(["x"])").director, (std::array{false, false, false}));
  EXPECT_EQ(full().fixes[0].director, (std::array{true, true, true}));
  EXPECT_EQ(full().fixes[1].director, (std::array{false, false, false}));
}

TEST(CaseReader, RefusesAPoissonNumberThatMakesASheetUnstable) {
  // ν₁₂ ν₂₁ = 0.4² · 9 > 1
  const auto text = with_material(
      "thickness = 1e-3\ndensity_area = 0.2\nwarp_modulus = 1e6\nweft_modulus = 9e6\n"
      "shear_modulus = 3e4\npoisson = [0.4]\n");
  try {
    (void)parse_case(text, "c.toml");
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.line(), 17);
    EXPECT_NE(error.message().find("0.4 is outside [0, 0.3333)"), std::string::npos) << error.what();
  }
}

TEST(CaseReader, ReadsDiscsAndAnnuli) {
  const std::string sheet = "shape = \"rectangle\"\nsize = [\"20 cm\", \"20 cm\"]\ncells = [10, 10]";
  const auto disc = parse_case(sample_with(sheet, "shape = \"disc\"\nradius = \"15 cm\"\ncells = 24"), "c.toml");
  expect_close(std::get<DiscShape>(disc.sheet().cloth.shape).radius, 0.15);
  EXPECT_EQ(std::get<DiscShape>(disc.sheet().cloth.shape).cells, 24);
  const std::string ring = "shape = \"annulus\"\ninner_radius = \"6 cm\"\nouter_radius = \"10 cm\"\ncells = [6, 30]";
  const auto annulus = parse_case(sample_with(sheet, ring), "c.toml");
  expect_close(std::get<AnnulusShape>(annulus.sheet().cloth.shape).inner_radius, 0.06);
  EXPECT_EQ(std::get<AnnulusShape>(annulus.sheet().cloth.shape).cells_around, 30);
  const std::string turned = "shape = \"annulus\"\ninner_radius = 2\nouter_radius = 1\ncells = [6, 30]";
  EXPECT_THROW((void)parse_case(sample_with(sheet, turned), "c.toml"), CaseError);
}

class CaseFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("case_file_") + test->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::filesystem::path folder_;
};

TEST_F(CaseFile, FindsItsMeshBesideItself) {
  write("sheet.obj", "v 0 0 0\n");
  write("case.toml", sample_with("shape = \"rectangle\"\nsize = [\"20 cm\", \"20 cm\"]\ncells = [10, 10]",
                                 "shape = \"mesh\"\nfile = \"sheet.obj\"\nunits = \"mm\""));
  const Case c = read_case(folder_ / "case.toml");
  const auto& mesh = std::get<MeshShape>(c.sheet().cloth.shape);
  EXPECT_TRUE(std::filesystem::equivalent(mesh.file, folder_ / "sheet.obj"));
  EXPECT_TRUE(mesh.file.is_absolute());
  expect_close(mesh.unit, 1e-3);
  EXPECT_EQ(mesh.source.line, 7);
  EXPECT_THROW((void)read_case(folder_ / "case.toml", {"cloth.units=kg"}), CaseError);
}

TEST_F(CaseFile, GivesAnUntitledCaseItsName) {
  write("plain.toml", sample_with("title = \"A sheet falls on a table\"", ""));
  EXPECT_EQ(read_case(folder_ / "plain.toml").title, "plain");
}

TEST_F(CaseFile, ThatIsNotThereIsNamed) {
  try {
    (void)read_case(folder_ / "nowhere.toml");
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere.toml: No such file"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)read_case(folder_), std::system_error);
}

}  // namespace
}  // namespace sundrape

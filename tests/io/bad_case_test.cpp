#include <gtest/gtest.h>

#include "sundrape/io/case_reader.hpp"

#include "case_samples.hpp"

namespace sundrape {
namespace {

/// One slip in the sample, and what the user must be told.
struct Slip {
  std::string name;
  std::string right, wrong;  // replaced in the sample
  int line;
  std::string key;
  std::string message;  // part of it
};

void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.name; }

class BadCase : public testing::TestWithParam<Slip> {};

TEST_P(BadCase, IsRefusedWithLineKeyAndReason) {
  const Slip& slip = GetParam();
  const std::string text = sample_with(slip.right, slip.wrong);
  try {
    (void)parse_case(text, "folder/CASE.toml");
    FAIL() << "accepted:\n" << text;
  } catch (const CaseError& error) {
    EXPECT_EQ(error.line(), slip.line) << error.what();
    EXPECT_EQ(error.key(), slip.key) << error.what();
    EXPECT_NE(error.message().find(slip.message), std::string::npos) << error.what();
    const std::string start = "folder/CASE.toml:" + std::to_string(slip.line) + ": ";
    EXPECT_EQ(std::string(error.what()), start + (slip.key.empty() ? "" : slip.key + ": ") + error.message());
    EXPECT_EQ(error.message().find('\n'), std::string::npos);
  }
}

const std::string fix_again = "[[fix]]\nnodes = { near = [0, 0, 0] }\n";

/// A polynomial bending test in the sample's material, with one of its keys as given.
std::string polynomial(const std::string& coefficients, const std::string& rest = "") {
  const std::string units = R"(curvature_unit = "1/cm", moment_unit = "gf*cm/cm", max_curvature = "2 1/cm")";
  return "bending = { law = \"polynomial\", coefficients = " + coefficients + ", " + (rest.empty() ? units : rest) +
         " }\npoisson";
}

/// The sample's first lines as a shell, with a table [shell].
std::string shell(const std::string& keys) { return "[shell]\n" + keys + "\n[cloth]"; }

const std::vector<Slip> slips{
    {"UnknownKey", "poisson", "poison", 15, "material.poison", "unknown key, did you mean 'poisson'?"},
    {"UnknownTable", "[dynamics]", "[dynamic]", 30, "dynamic", "unknown key, did you mean 'dynamics'?"},
    {"KeyOfAnotherTable", "poisson", "rtol = 1e-3\npoisson", 15, "material.rtol",
     "unknown key here; it belongs to dynamics"},
    {"NearKeyOfAnotherTable", "poisson", "max_ordr = 1\npoisson", 15, "material.max_ordr",
     "did you mean 'max_order' of dynamics?"},
    {"UnknownInlineKey", "translate", "transalte", 9, "cloth.place.transalte", "did you mean 'translate'?"},
    {"NothingLikeIt", "rtol", "qqqqqq", 33, "dynamics.qqqqqq", "unknown key; accepted: integrator, duration,"},
    {"WrongDimension", "0.54229 mm", "0.54229 kg", 12, "material.thickness",
     "'0.54229 kg' is a mass, a length is expected"},
    {"UnknownUnit", "0.54229 mm", "0.54229 mn", 12, "material.thickness", "unknown unit 'mn'"},
    {"OunceForOunceForce", "118.1176 gf/mm^2", "4196 oz/in^2", 14, "material.youngs_modulus", "write 'ozf'"},
    {"UnitOfAPlainNumber", "= 0.3", "= \"0.3 mm\"", 15, "material.poisson", "a plain number is expected, not '0.3 mm'"},
    {"PoissonTooLarge", "= 0.3", "= 0.7", 15, "material.poisson", "0.7 is outside [0, 0.5)"},
    {"NegativeThickness", "0.54229 mm", "-0.5 mm", 12, "material.thickness", "'-0.5 mm' is outside (0, inf) m"},
    {"NoThickness", "\"0.54229 mm\"", "0", 12, "material.thickness", "0 is outside (0, inf) m"},
    {"NaN", "\"0.54229 mm\"", "nan", 12, "material.thickness", "nan is not a finite number"},
    {"InfiniteDuration", "\"0.2 s\"", "inf", 32, "dynamics.duration", "inf is not a finite number"},
    {"NaNInAList", "-9.80665", "nan", 23, "load.0.acceleration", "nan is not a finite number"},
    {"HalfACell", "[10, 10]", "[10, 10.5]", 8, "cloth.cells", "a whole number is expected, not 10.5"},
    {"NoCells", "[10, 10]", "[0, 10]", 8, "cloth.cells", "0 is outside [1, 10000]"},
    {"OneCellNumber", "[10, 10]", "10", 8, "cloth.cells", "a list of 2 is expected, not 10"},
    {"ThreeCellNumbers", "[10, 10]", "[1, 2, 3]", 8, "cloth.cells", "a list of 2 is expected, not of 3"},
    {"FlatPoint", "[0, 0, \"1 mm\"]", "[0, 0]", 9, "cloth.place.translate", "a list of 3 is expected, not of 2"},
    {"NumberForAString", "\"A sheet falls on a table\"", "3", 1, "title", "a string is expected, not 3"},
    {"StringForATable", "{ translate = [0, 0, \"1 mm\"] }", "\"here\"", 9, "cloth.place",
     "a table is expected, not 'here'"},
    {"MisspeltChoice", "\"cvode\"", "\"cvod\"", 31, "dynamics.integrator",
     "'cvod' is not one of cvode, ida, rk4, dirk, did you mean 'cvode'?"},
    {"UnknownModel", "\"particle\"", "\"shells\"", 2, "model",
     "'shells' is not one of particle, shell, did you mean 'shell'?"},
    {"ShellTableOfAParticleNet", "[cloth]", shell("membrane = \"mixed\""), 5, "shell",
     R"(belongs to model = "shell", not to "particle")"},
    {"UnknownMembrane", "[cloth]", shell("membrane = \"center\""), 6, "shell.membrane",
     "'center' is not one of centre, bilinear, edge-tied, mixed, did you mean 'centre'?"},
    {"NoShearCorrection", "[cloth]", shell("shear_correction = 0"), 6, "shell.shear_correction",
     "0 is outside (0, 10]"},
    {"TooMuchRotaryInertia", "[cloth]", shell("rotary_inertia = 1001"), 6, "shell.rotary_inertia",
     "1001 is outside (0, 1000]"},
    {"DirectorOfAParticle", R"(["x", "y"])", R"(["x", "director-y"])", 19, "fix.0.components",
     "'director-y' needs the director of a shell node, hence model = \"shell\""},
    {"ResultantsOfAWord", "frames = 10", "resultants = \"all\"", 36, "output.resultants",
     "true or false is expected, not 'all'"},
    {"MisspeltAnalysis", "\"dynamics\"", "\"arclength\"", 3, "analysis",
     "'arclength' is not one of dynamics, relaxation, arc-length, did you mean 'arc-length'?"},
    {"NoAnalysis", "analysis = \"dynamics\"\n", "\n", 1, "analysis", "missing; accepted: dynamics, relaxation"},
    {"NoShape", "shape = \"rectangle\"\n", "\n", 5, "cloth.shape", "missing; accepted: rectangle, disc"},
    {"NoSize", "size = [\"20 cm\", \"20 cm\"]\n", "\n", 5, "cloth.size", "missing"},
    {"NoKind", "kind = \"box\"\n", "\n", 25, "obstacle.0.kind", "missing; accepted: plane, box"},
    {"NoDuration", "duration = \"0.2 s\"\n", "\n", 30, "dynamics.duration", "missing"},
    {"NoWeight", "weight = \"0.2384e-3 gf/mm^2\"\n", "\n", 11, "material.weight",
     "one of weight, density_area, density"},
    {"WeightTwice", "poisson", "density = 300\npoisson", 15, "material.density",
     "given twice over, by weight and density"},
    {"NoModulus", "youngs_modulus = \"118.1176 gf/mm^2\"\n", "\n", 11, "material.youngs_modulus", "missing"},
    {"ModulusTwice", "poisson", "warp_modulus = 1e6\npoisson", 15, "material.warp_modulus", "give either, not both"},
    {"HalfOrthotropic", "youngs_modulus", "warp_modulus", 11, "material.weft_modulus",
     "missing: an orthotropic fabric needs"},
    {"FallingPolynomial", "poisson", polynomial("[1, -0.26]"), 15, "material.bending.coefficients",
     "does not grow all the way to its largest curvature"},
    {"FallingPolynomialOfTheWeft", "poisson", polynomial("[[1, 1], [1, -0.26]]"), 15, "material.bending.coefficients",
     "does not grow all the way to its largest curvature"},
    {"TooManyCoefficients", "poisson", polynomial("[1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"), 15,
     "material.bending.coefficients", "a list of 1 to 9 numbers is expected, not of 10"},
    {"NoCoefficients", "poisson", polynomial("[]"), 15, "material.bending.coefficients",
     "a list of 1 to 9 numbers is expected, not of 0"},
    {"CoefficientsOfThreeThreads", "poisson", polynomial("[[1], [1], [1]]"), 15, "material.bending.coefficients",
     "[warp list, weft list] is expected, not 3 lists"},
    {"CoefficientsOfOneThreadAndANumber", "poisson", polynomial("[[1], 1]"), 15, "material.bending.coefficients",
     "a list of numbers is expected, not 1"},
    {"CoefficientsWithUnits", "poisson", polynomial("[\"1 gf\"]"), 15, "material.bending.coefficients",
     "a plain number is expected, not '1 gf'"},
    {"OneCoefficient", "poisson", polynomial("1"), 15, "material.bending.coefficients",
     "a list of numbers is expected, not 1"},
    {"CurvatureOverLength", "poisson",
     polynomial("[1]", R"(curvature_unit = "cm", moment_unit = "gf", max_curvature = 1)"), 15,
     "material.bending.curvature_unit", "'cm' is not the unit of a curvature"},
    {"NoMomentUnit", "poisson", polynomial("[1]", R"(curvature_unit = "1/cm", max_curvature = 1)"), 15,
     "material.bending.moment_unit", "missing"},
    {"RigidityOfAPolynomial", "poisson", polynomial("[1]", "rigidity = 1"), 15, "material.bending.rigidity",
     "belongs to law = linear, not to 'polynomial', which takes: law, coefficients,"},
    {"ThreadsTooDifferent", "poisson", polynomial("[[100], [1]]"), 15, "material.bending.coefficients",
     "differs too much for Poisson's ratio"},
    {"StripsTooDifferent", "poisson", "bending = { rigidity = [1, 12] }\npoisson", 15, "material.bending.rigidity",
     "the rigidity of the weft must stay below 11.11 times that of the warp"},
    {"KeyOfAnotherShape", "cells", "radius = 1\ncells", 8, "cloth.radius",
     "belongs to shape = disc, not to 'rectangle', which takes: shape,"},
    {"ThinAir", "\"gravity\"", "\"wind\"\ndensity = -1", 23, "load.0.density", "-1 is outside [0, inf)"},
    {"GustWithoutSize", "\"gravity\"", "\"wind\"\ngust = { period = 2 }", 23, "load.0.gust.amplitude", "missing"},
    {"MotionWithoutPath", "[[fix]]", "[[motion]]\nnodes = \"left\"\n[[fix]]", 17, "motion.0.path",
     "missing: Where to."},
    {"MotionInTime", "[[fix]]", "[[motion]]\nnodes = \"left\"\npath = { kind = \"line\", by = [0, 0, 1] }\n[[fix]]", 19,
     "motion.0.path.duration", "missing: how long the path takes"},
    {"MotionOfNoKind", "[[fix]]", "[[motion]]\nnodes = \"left\"\npath = { by = [0, 0, 1] }\n[[fix]]", 19,
     "motion.0.path.kind", "missing; accepted: arc, line, keyframes"},
    {"StagesWithoutEntries", "kind = \"gravity\"", "kind = \"gravity\"\nstages = []", 23, "load.0.stages",
     "a list of 1 to 20 numbers is expected, not of 0"},
    {"MovingObstacle", "kind = \"box\"", "kind = \"box\"\nmotion = {}", 27, "obstacle.0.motion.kind",
     "missing; accepted: arc, line, keyframes"},
    {"NegativeFriction", "kind = \"box\"", "kind = \"box\"\nfriction = -0.3", 27, "obstacle.0.friction",
     "-0.3 is outside [0, inf)"},
    {"WideSelfContact", "[output]", "[contact]\nself = true\nsmoothing = 1\n[output]", 37, "contact.smoothing",
     "1 m is not less than contact.thickness"},
    {"SelfContactWithRestitution", "[output]", "[contact]\nself = true\nrestitution = 0.5\n[output]", 37,
     "contact.restitution", "impacts know obstacles only"},
    {"SharpCorners", "kind = \"box\"", "kind = \"box\"\nedge_radius = \"5 cm\"", 27, "obstacle.0.edge_radius",
     "0.05 m is outside [0, 0.04] m"},
    {"SingleTableForMany", "[[fix]]", "[fix]", 17, "fix", "write [[fix]], not [fix]"},
    {"TwoPieces", "[cloth]",
     "[[cloth]]\nshape = \"disc\"\nradius = 1\ncells = 4\nname = \"a\"\n[[cloth]]\nname = \"a\"", 11, "cloth.1.name",
     "'a' is already the name of another piece"},
    {"TwoSelectors", "near = [0, 0, 0]", "near = [0, 0, 0], box = [[0,0,0],[1,1,1]]", 18, "fix.0.nodes",
     "exactly one of near, box, plane, sphere"},
    {"UnknownSelector", "near", "nearest", 18, "fix.0.nodes.nearest", "did you mean 'near'?"},
    {"HalfABox", "near = [0, 0, 0]", "box = [[0, 0, 0]]", 18, "fix.0.nodes.box", "two opposite corners"},
    {"UnknownComponent", R"(["x", "y"])", R"(["x", "w"])", 19, "fix.0.components",
     "'w' is not one of x, y, z, rotation, director-x"},
    {"NoComponent", R"(["x", "y"])", "[]", 19, "fix.0.components", "an empty one"},
    {"SupportsInConflict", "[[load]]", fix_again + "[[load]]", 22, "fix.1.nodes",
     "in conflict with the support at line 18"},
    {"SupportsOfOneName", "components", "name = \"a\"\n[[fix]]\nnodes = \"left\"\nname = \"a\"\ncomponents", 22,
     "fix.1.name", "'a' is already the name of the support at line 18"},
    {"NameWithASlash", "\"corner\"", "\"a/b\"", 37, "output.probes.0.name",
     "'a/b' cannot name a group of the result file"},
    {"NoNormal", "kind = \"box\"\nsize = [\"8 cm\", \"8 cm\", \"8 cm\"]", "kind = \"plane\"\nnormal = [0, 0, 0]", 27,
     "obstacle.0.normal", "a direction needs a length"},
    {"FramesTwice", "frames = 10", "frames = 10\nevery = \"1 ms\"", 37, "output.every", "give either, not both"},
    {"TooManyFrames", "frames = 10", "every = 1e-9", 36, "output.every", "makes more than"},
    {"IntegerPastADouble", "= 0.3", "= -9223372036854775808", 15, "material.poisson", "is outside [0, 0.5)"},
    {"OrderTooHigh", "rtol = 1e-3", "max_order = 6", 33, "dynamics.max_order", "6 is outside [1, 5]"},
    {"UnusedAnalysisIsCheckedToo", "[output]", "[relaxation]\ntolerance = 2\n[output]", 36, "relaxation.tolerance",
     "2 is outside (0, 0.1]"},
    {"MissingMesh", "shape = \"rectangle\"\nsize = [\"20 cm\", \"20 cm\"]\ncells = [10, 10]",
     "shape = \"mesh\"\nfile = \"none.obj\"", 7, "cloth.file", "'none.obj' is not there"},
    {"UnclosedTable", "[cloth]", "[cloth", 5, "", ""},
    {"KeyTwice", "poisson = 0.3", "poisson = 0.3\npoisson = 0.3", 16, "", ""},
};

INSTANTIATE_TEST_SUITE_P(Of, BadCase, testing::ValuesIn(slips), [](const auto& info) { return info.param.name; });

TEST(MasslessDirectors, NeedIda) {
  const auto text = sample_with("[cloth]", shell("director = \"massless\""));
  const auto read = [&](const std::string& integrator) {
    (void)parse_case(text, "CASE.toml", {"model=shell", "dynamics.integrator=" + integrator});
  };
  EXPECT_NO_THROW(read("ida"));
  for (const auto* integrator : {"cvode", "rk4", "dirk"}) {
    try {
      read(integrator);
      FAIL() << integrator;
    } catch (const CaseError& error) {
      EXPECT_EQ(error.line(), 6);
      EXPECT_EQ(error.key(), "shell.director");
      EXPECT_NE(error.message().find(std::string("dynamics.integrator = \"") + integrator + "\" cannot solve"),
                std::string::npos)
          << error.what();
    }
  }
  // statics has no integrator
  EXPECT_NO_THROW((void)parse_case(text, "CASE.toml", {"model=shell", "analysis=relaxation"}));
}

TEST(ChapterScheme, IsOfTheParticleNet) {
  const auto text = sample_with("[cloth]", "[relaxation]\nscheme = \"chapter\"\n[cloth]");
  EXPECT_NO_THROW((void)parse_case(text, "CASE.toml", {"analysis=relaxation"}));
  try {
    (void)parse_case(text, "CASE.toml", {"model=shell", "analysis=relaxation"});
    FAIL() << "directors have no displacement per force";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.key(), "relaxation.scheme");
  }
}

TEST(MasslessDirectors, NeedDamping) {
  const auto text = sample_with("[cloth]", shell("director = \"massless\""));
  for (const auto* kind : {"membrane", "bending"}) {
    try {
      (void)parse_case(text, "CASE.toml",
                       {"model=shell", "dynamics.integrator=ida", std::string("material.damping.") + kind + "=0"});
      FAIL() << kind;
    } catch (const CaseError& error) {
      EXPECT_EQ(error.key(), "shell.director");
      EXPECT_NE(error.message().find(std::string("material.damping.") + kind), std::string::npos) << error.what();
    }
  }
}

TEST(MasslessDirectors, NeedDampingInEveryPiece) {
  const auto text = sample_with("[cloth]", shell("director = \"massless\"")) +
                    "\n[[cloth]]\nname = \"lining\"\nshape = \"rectangle\"\nsize = [0.1, 0.1]\ncells = [2, 2]\n"
                    "material = { thickness = 1e-3, weight = 2, youngs_modulus = 1e6, poisson = 0.3, "
                    "damping = { membrane = 1e-3, bending = 0 } }\n";
  const auto two = std::string(text).replace(text.find("[cloth]"), 7, "[[cloth]]\nname = \"top\"");
  try {
    (void)parse_case(two, "CASE.toml", {"model=shell", "dynamics.integrator=ida"});
    FAIL() << "the lining has no damping of bending";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.key(), "shell.director");
    EXPECT_NE(error.message().find("material.damping.bending > 0 for cloth 'lining'"), std::string::npos)
        << error.what();
  }
}

TEST(BadCaseOfTwoSlips, ReportsTheFirstInTheFile) {
  try {
    (void)parse_case(sample_with("cells", "zells") + "[zzz]\n", "CASE.toml");
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.line(), 8) << error.what();
  }
}

}  // namespace
}  // namespace sundrape

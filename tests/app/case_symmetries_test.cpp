#include "sundrape/app/case_symmetries.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/app/shape_distance.hpp"

#include "sample_cases.hpp"

namespace sundrape {
namespace {

const std::string square = "shape = \"rectangle\"\nsize = [0.08, 0.08]\ncells = [6, 6]";
const std::string oblong = "shape = \"rectangle\"\nsize = [0.08, 0.04]\ncells = [6, 4]";
const std::string table =
    "[[obstacle]]\nkind = \"box\"\nsize = [0.04, 0.04, 0.02]\nplace = { translate = [0, 0, -0.01] ";
const std::string floor = "[[obstacle]]\nkind = \"plane\"\n";

std::string pin(const std::string& near, const std::string& components) {
  return "[[fix]]\nname = \"" + near + "\"\nnodes = { near = " + near + " }\ncomponents = " + components + "\n";
}
const std::string centre_pin = pin("[0, 0, 0]", R"(["x", "y"])");

CaseSymmetries of(const std::string& sheet, const std::string& more, const std::string& model = "particle") {
  return find_case_symmetries(samples::model_of("model = \"" + model + "\"\n" + samples::sheet_case(more, sheet)));
}

/// Orders of the point groups: of a square seen from above 8, of what is turned against it 4 (turns alone), and so on.
TEST(CaseSymmetries, AreThoseOfTheSheetThatItsTableHasToo) {
  for (const std::string model : {"particle", "shell"}) {
    EXPECT_EQ(of(square, centre_pin + table + "}\n", model).maps.size(), 8U) << model;
    EXPECT_EQ(of(oblong, centre_pin + table + "}\n", model).maps.size(), 4U) << model;
    EXPECT_EQ(of(square, centre_pin + table + ", rotate = { angle = 0.3 } }\n", model).maps.size(), 4U) << model;
    const std::string aside =
        "[[obstacle]]\nkind = \"box\"\nsize = [0.04, 0.04, 0.02]\nplace = { translate = [0.003, 0, -0.01] }\n";
    EXPECT_EQ(of(square, centre_pin + aside, model).maps.size(), 2U) << model;
  }
}

TEST(CaseSymmetries, AreThoseThatSupportsLeave) {
  const std::string all = R"(["x", "y", "z"])";
  for (const std::string model : {"particle", "shell"}) {
    // the diagonal; and a sheet on the other side of its corner
    EXPECT_EQ(of(square, pin("[0.04, 0.04, 0]", all), model).maps.size(), 2U * 2U) << model;
    EXPECT_EQ(of(square, pin("[0.04, 0.04, 0]", all) + pin("[-0.04, -0.04, 0]", all), model).maps.size(), 4U) << model;
    // a director across the edge leaves open which side the sheet is on; the slope of a net does not
    EXPECT_EQ(of(square, "[[fix]]\nnodes = \"left\"\n", model).maps.size(), model == "shell" ? 4U : 2U) << model;
    // held in x alone, which the diagonal would turn into y; that leaves the mirror y -> -y of space
    EXPECT_EQ(of(square, pin("[0.04, 0.04, 0]", R"(["x", "z"])") + centre_pin, model).maps.size(), 2U) << model;
  }
}

TEST(CaseSymmetries, AreThoseOfSupportsAndObstaclesAtTheEndsOfTheirPaths) {
  const auto carried = [](const std::string& near, const std::string& by) {
    return "[[motion]]\nname = \"" + near + "\"\nnodes = { near = " + near +
           " }\npath = { kind = \"line\", by = " + by + ", duration = 1 }\n";
  };
  const std::string a = "[0.04, 0.04, 0]", b = "[-0.04, -0.04, 0]";
  EXPECT_EQ(of(square, carried(a, "[-0.01, -0.01, 0]") + carried(b, "[0.01, 0.01, 0]")).maps.size(), 4U);
  // what is left is the mirror of space through both corners
  EXPECT_EQ(of(square, carried(a, "[-0.01, 0, 0]") + carried(b, "[0, 0, 0.01]")).maps.size(), 2U);
  EXPECT_EQ(of(square, centre_pin + table + "}\n").maps.size(), 8U);
  EXPECT_EQ(of(square, centre_pin + table.substr(0, table.rfind("place")) +
                           "place = { translate = [0, 0, -0.01] }\nmotion = { kind = \"line\", by = [0.003, 0, 0], "
                           "duration = 1 }\n")
                .maps.size(),
            2U);
}

TEST(CaseSymmetries, AreThoseThatLoadsLeave) {
  const std::string pull = "[[load]]\nkind = \"force\"\nnodes = \"top_right\"\ntotal = [1e-3, 1e-3, 0]\n";
  EXPECT_EQ(of(square, centre_pin + pull).maps.size(), 2U);
  EXPECT_EQ(of(square, centre_pin + "[[load]]\nkind = \"gravity\"\nacceleration = [1, 0, 0]\n").maps.size(), 2U);
  // without weight either side may be up
  const std::string weightless = "[[load]]\nkind = \"gravity\"\nacceleration = [0, 0, 9.80665]\n";
  EXPECT_EQ(of(square, centre_pin + weightless).maps.size(), 16U);
}

TEST(CaseSymmetries, AreThoseOfTheFabric) {
  // warp twice as stiff as weft: a quarter turn makes another sheet of it
  const std::string woven =
      "analysis = \"relaxation\"\n[cloth]\n" + square +
      "\n[material]\nthickness = \"0.5 mm\"\ndensity_area = 0.2\nwarp_modulus = \"2 MPa\"\nweft_modulus = \"1 MPa\"\n"
      "shear_modulus = \"0.3 MPa\"\npoisson = 0\n[[load]]\nkind = \"gravity\"\n" +
      centre_pin;
  for (const std::string model : {"model = \"particle\"\n", "model = \"shell\"\n"})
    EXPECT_EQ(find_case_symmetries(samples::model_of(model + woven)).maps.size(), 4U) << model;
}

TEST(CaseSymmetries, GoWithThePlaceOfTheSheet) {
  const auto found = of(square + "\nplace = { translate = [1, 2, 0], rotate = { axis = [0, 0, 1], angle = 0.4 } }",
                        pin("[1, 2, 0]", R"(["x", "y"])") +
                            "[[obstacle]]\nkind = \"box\"\nsize = [0.04, 0.04, 0.02]\n"
                            "place = { translate = [1, 2, -0.01], rotate = { axis = [0, 0, 1], angle = 0.4 } }\n");
  EXPECT_EQ(found.maps.size(), 8U);
  EXPECT_LT((found.maps.back().centre - Vector3(1, 2, 0)).norm(), 1e-12);
}

// Held at two corners, a tilted sheet hangs to one side or to the other: mirror images across the plane of the corners,
// which is none of the sheet's own.
TEST(CaseSymmetries, HaveTheMirrorThatATiltedSheetHangsIn) {
  const std::string tilted = square + "\nplace = { rotate = { axis = [1, 0, 0], angle = 1.0 } }";
  const std::string corners =
      "[[fix]]\nnodes = \"top_left\"\ncomponents = [\"x\", \"y\", \"z\"]\n"
      "[[fix]]\nnodes = \"top_right\"\ncomponents = [\"x\", \"y\", \"z\"]\n";
  for (const std::string kind : {"particle", "shell"}) {
    const auto model = samples::model_of("model = \"" + kind + "\"\n" + samples::sheet_case(corners, tilted));
    const auto symmetries = find_case_symmetries(model);
    EXPECT_EQ(symmetries.maps.size(), 4U) << kind;  // left and right change places or not, and both mirrored
    const int corner = model.reactions.front().nodes.front();
    Vector mirrored = model.initial;
    for (int p = 0; p < static_cast<int>(mirrored.size() / 3); ++p)
      mirrored[3 * p + 1] = (p < model.mesh.nodes() ? 2 * model.initial[3 * corner + 1] : 0) - mirrored[3 * p + 1];
    EXPECT_GT((mirrored - model.initial).norm(), 0.1);
    EXPECT_LT(shape_distance(symmetries, model.mesh.nodes(), model.initial, mirrored).rms, 1e-12) << kind;
  }
}

TEST(NeutralMotions, OfAFreeSheetOnATable) {
  const auto free = of(square, floor).neutral;
  EXPECT_EQ(free.slides.size(), 2U);
  EXPECT_TRUE(free.pivot.has_value());
  const auto pinned = of(square, floor + centre_pin).neutral;
  EXPECT_EQ(pinned.slides.size(), 0U);
  EXPECT_TRUE(pinned.pivot.has_value());
  EXPECT_FALSE(of(square, table + "}\n").neutral.any());
  EXPECT_FALSE(of(square, floor + "[[fix]]\nnodes = \"left\"\n").neutral.any());
}

TEST(NeutralMotions, OfASheetOverASphereAndOverARod) {
  const std::string sphere =
      "[[obstacle]]\nkind = \"sphere\"\nradius = 0.02\nplace = { translate = [0.005, 0, -0.02] }\n";
  const auto on_sphere = of(square, sphere).neutral;
  EXPECT_EQ(on_sphere.slides.size(), 0U);
  ASSERT_TRUE(on_sphere.pivot.has_value());
  EXPECT_DOUBLE_EQ(on_sphere.pivot->x(), 0.005);
  const auto on_rod = of(square,
                         "[[obstacle]]\nkind = \"cylinder\"\nradius = 0.02\nlength = 1\naxis = [3, 4, 0]\n"
                         "place = { translate = [0, 0, -0.02] }\n")
                          .neutral;
  ASSERT_EQ(on_rod.slides.size(), 1U);
  EXPECT_NEAR(std::abs(on_rod.slides.front().dot(Vector3(0.6, 0.8, 0))), 1, 1e-6);
  EXPECT_FALSE(on_rod.pivot.has_value());
}

/// A state without any symmetry of its own.
Vector bent(const CaseModel& model) {
  Vector q = model.initial;
  for (int i = 0; i < model.mesh.nodes(); ++i) {
    const Vector3 x = point(q, i);
    point(q, i).z() += 3 * x.x() * x.x() - x.y() * x.x() + 0.2 * x.y();
  }
  return q;
}

TEST(ShapeDistance, OfAStateAndItsImagesIsNothing) {
  for (const std::string kind : {"particle", "shell"}) {
    const auto model =
        samples::model_of("model = \"" + kind + "\"\n" + samples::sheet_case(centre_pin + table + "}\n", square));
    const auto symmetries = find_case_symmetries(model);
    const Vector q = bent(model);
    for (const auto& map : symmetries.maps) {
      const Vector image = map.move(q);
      const auto apart = shape_distance(symmetries, model.mesh.nodes(), q, image);
      EXPECT_LT(apart.rms, 1e-12);
      EXPECT_LT((apart.aligned - q).norm(), 1e-10) << kind;  // directors come back too
      EXPECT_GE((image - q).norm(), &map == &symmetries.maps.front() ? 0 : 1e-3);
    }
  }
}

TEST(ShapeDistance, ForgetsHowFarAFreeSheetSlidAndTurnedButNotItsHeight) {
  const auto model = samples::model_of(samples::sheet_case(floor, square));
  const auto symmetries = find_case_symmetries(model);
  const Vector q = bent(model);
  PointMap moved{.rotation = Eigen::AngleAxisd(0.5, Vector3::UnitZ()).matrix(), .centre = {0.3, -0.1, 0}, .image = {}};
  moved.image = symmetries.maps.front().image;
  moved.places = model.mesh.nodes();
  Vector other = moved.move(q);
  EXPECT_LT(shape_distance(symmetries, model.mesh.nodes(), q, other).rms, 1e-12);
  for (int i = 0; i < model.mesh.nodes(); ++i) point(other, i) += Vector3(0.01, 0.02, 1e-4);
  const auto apart = shape_distance(symmetries, model.mesh.nodes(), q, other);
  EXPECT_NEAR(apart.rms, 1e-4, 1e-10);
  EXPECT_NEAR(apart.max, 1e-4, 1e-10);
}

TEST(ShapeDistance, IsTheRootMeanSquareOverTheNodes) {
  const auto model = samples::model_of(samples::sheet_case("[[fix]]\nnodes = \"left\"\n", square));
  const auto symmetries = find_case_symmetries(model);
  const Vector q = bent(model);
  Vector other = q;
  point(other, 48) += Vector3(0, 0, 7e-4);  // one of 49 nodes
  const auto apart = shape_distance(symmetries, model.mesh.nodes(), q, other);
  EXPECT_NEAR(apart.rms, 1e-4, 1e-12);
  EXPECT_NEAR(apart.max, 7e-4, 1e-12);
  EXPECT_EQ(apart.map, 0U);
}

}  // namespace
}  // namespace sundrape

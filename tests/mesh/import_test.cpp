#include "sundrape/mesh/import.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

/// A file with the given text, gone at the end of the test.
class ObjFile : public ::testing::Test {
 protected:
  [[nodiscard]] QuadMesh read(const std::string& text, double unit = 1) const {
    std::ofstream(file_) << text;
    return read_obj(file_, unit);
  }
  [[nodiscard]] std::string problem_with(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const std::invalid_argument& problem) {
      const std::string message = problem.what();
      EXPECT_EQ(message.find(file_.string() + ":"), 0U) << message;
      return message.substr(file_.string().size() + 1);
    }
    return "accepted";
  }
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_ =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("sundrape_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".obj");
};

const std::string square = "v 0 0 0\nv 10 0 0\nv 10 10 1\nv 0 10 1\n";
const std::string strip = square + "v 20 0 0\nv 20 10 0\n";

TEST_F(ObjFile, QuadsComeInAsTheyStandScaledToMetres) {
  const auto mesh =
      read("# a comment\r\nmtllib none.mtl\r\n" + square + "vn 0 0 1\nusemtl cotton\ns off\nf 1 2 3 4\n", 0.01);
  ASSERT_EQ(mesh.nodes(), 4);
  EXPECT_TRUE(mesh.reference[2].isApprox(Vector3(0.1, 0.1, 0.01)));
  EXPECT_TRUE(mesh.material[2].isApprox(Eigen::Vector2d(0.1, 0.1)));
  EXPECT_EQ(mesh.quads.front(), (std::array<int, 4>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.sets.at("boundary").size(), 4U);
  EXPECT_EQ(mesh.sets.at("all").size(), 4U);
}

TEST_F(ObjFile, TextureCoordinatesBecomeMaterialOnes) {
  const auto mesh = read(square + "vt 1 1\nvt 2 1\nvt 2 3\nvt 1 3\nvn 0 0 1\nf 1/2/1 2/3/1 3/4/1 4/1/1\n", 0.5);
  EXPECT_EQ(mesh.material[0], Eigen::Vector2d(1, 0.5));
  EXPECT_EQ(mesh.material[3], Eigen::Vector2d(0.5, 0.5));
}

TEST_F(ObjFile, GroupsAndObjectsBecomeNodeSets) {
  const auto mesh = read(strip + "o cloth\ng hem seam\nf 1 2 3 4\ng seam\nf -5 -2 -1 -4\n");
  EXPECT_EQ(mesh.sets.at("cloth").size(), 6U);
  EXPECT_EQ(mesh.sets.at("hem"), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.sets.at("seam").size(), 6U);
  EXPECT_EQ(mesh.quads[1], (std::array<int, 4>{1, 4, 5, 2}));
}

TEST_F(ObjFile, OtherFacesThanQuadsAreRefusedWithTheirLine) {
  EXPECT_EQ(problem_with(square + "f 1 2 3\n"), "5: a face with 3 corners; sundrape takes quads only");
  EXPECT_EQ(problem_with(strip + "\nf 1 2 5 6 4\n"), "8: a face with 5 corners; sundrape takes quads only");
}

TEST_F(ObjFile, BadIndicesAreRefusedWithTheirLine) {
  EXPECT_EQ(problem_with(square + "f 1 2 3 5\n"), "5: a face names vertex 5, but the file has 4 up to here");
  EXPECT_EQ(problem_with(square + "f 1 2 3 -5\n"), "5: a face names vertex -5, but the file has 4 up to here");
  EXPECT_EQ(problem_with(square + "f 1 2 0 4\n"), "5: a face names vertex 0, but the file has 4 up to here");
  EXPECT_EQ(problem_with(square + "f 1 2 3 3\n"), "5: a face that names vertex 3 twice");
  EXPECT_EQ(problem_with(square + "vt 0 0\nf 1/1 2/2 3/1 4/1\n"),
            "6: a face names texture coordinate 2, but the file has 1 up to here");
}

TEST_F(ObjFile, WordsThatAreNoNumbersAreRefused) {
  EXPECT_EQ(problem_with("v 0 zero 0\n"), "1: \"zero\" in a line of \"v\" is not a number");
  EXPECT_EQ(problem_with("v 0 nan 0\n"), "1: \"nan\" in a line of \"v\" is not a number");
  EXPECT_EQ(problem_with("v 0 0\n"), "1: a line of \"v\" needs 3 numbers, not 2");
  EXPECT_EQ(problem_with(square + "f 1 2 3 d\n"), "5: \"d\" in a line of \"f\" is not a number");
}

TEST_F(ObjFile, SheetsThatAreNoneAreRefused) {
  EXPECT_EQ(problem_with(""), " there is no face in it");
  EXPECT_EQ(problem_with(strip + "f 1 2 3 4\n"), " no quad uses node 4 (counted from 0)");
  EXPECT_NE(problem_with(strip + "f 1 2 3 4\nf 2 3 6 5\n").find("opposite senses"), std::string::npos);
}

TEST_F(ObjFile, HalfGivenOrSplitMaterialCoordinatesAreRefused) {
  const std::string textured = strip + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
  EXPECT_EQ(problem_with(textured + "f 2 5 6 3\n"), " some faces have texture coordinates and some have none");
  EXPECT_EQ(problem_with(textured + "f 2/1 5/2 6/3 3/4\n"), "12: vertex 2 gets a second texture coordinate: a seam");
}

TEST_F(ObjFile, TheMeshsOwnSetNamesAreTaken) {
  EXPECT_EQ(problem_with(square + "g boundary\nf 1 2 3 4\n"),
            "5: the set name \"boundary\" is the mesh's own; call the group something else");
}

TEST_F(ObjFile, AMissingFileIsAnErrorOfItsOwn) {
  EXPECT_THROW((void)read_obj("no_such_file.obj", 1), std::runtime_error);
  EXPECT_THROW((void)read_obj(::testing::TempDir(), 1), std::runtime_error);
  EXPECT_THROW((void)read(square + "f 1 2 3 4\n", 0), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

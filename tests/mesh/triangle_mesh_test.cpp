#include "sundrape/mesh/triangle_mesh.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "support/triangle_meshes.hpp"

namespace sundrape {
namespace {

const Vector3 size_in_cm(10, 8, 6);

std::string as_obj(const TriangleMesh& mesh) {
  std::ostringstream text;
  for (const auto& x : mesh.vertices) text << "v " << x.transpose() << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  return text.str();
}

std::string as_ply(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& x : mesh.vertices) text << x.transpose() << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << "3 " << a << ' ' << b << ' ' << c << '\n';
  return text.str();
}

std::string as_stl(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "solid body\n";
  for (const auto& triangle : mesh.triangles) {
    text << " facet normal 0 0 0\n  outer loop\n";
    for (const int v : triangle) text << "   vertex " << mesh.vertices[static_cast<std::size_t>(v)].transpose() << '\n';
    text << "  endloop\n endfacet\n";
  }
  return text.str() + "endsolid body\n";
}

std::string as_binary_stl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto put = [&](std::uint32_t word) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>((word >> (8 * k)) & 0xFFU);
  };
  put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) put(std::bit_cast<std::uint32_t>(0.0F));
    for (const int v : triangle)
      for (const double coordinate : mesh.vertices[static_cast<std::size_t>(v)])
        put(std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

/// A file that is gone at the end of the test.
class MeshFile : public ::testing::Test {
 protected:
  [[nodiscard]] TriangleMesh read(const std::string& ending, const std::string& content, double unit = 0.01) {
    file_ = std::filesystem::path(::testing::TempDir()) /
            (std::string("sundrape_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ending);
    std::ofstream(file_, std::ios::binary) << content;
    return read_triangle_mesh(file_, unit);
  }
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_;
};

std::string problem_with(const TriangleMesh& mesh) {
  try {
    check_closed(mesh);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "accepted";
}

bool says(const std::string& message, const std::string& part) { return message.find(part) != std::string::npos; }

TEST_F(MeshFile, TheSameBoxComesInFromEveryFormat) {
  const auto box = box_mesh(size_in_cm);
  for (const auto& [ending, content] :
       {std::pair{".obj", as_obj(box)}, {".ply", as_ply(box)}, {".stl", as_stl(box)}, {".STL", as_binary_stl(box)}}) {
    const auto mesh = read(ending, content);
    EXPECT_EQ(mesh.vertices.size(), 8U) << ending;
    EXPECT_EQ(mesh.triangles.size(), 12U) << ending;
    EXPECT_EQ(problem_with(mesh), "accepted") << ending;
    // single precision
    EXPECT_NEAR(volume(mesh), 480e-6, 1e-6 * 480e-6) << ending;
    EXPECT_TRUE(bounds(mesh).max().isApprox(Vector3(0.05, 0.04, 0.03), 1e-6)) << ending;
    TearDown();
  }
}

TEST_F(MeshFile, PolygonsAreCutIntoTrianglesAndPartsTakenTogether) {
  const auto mesh = read(".obj",
                         "o low\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                         "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\no high\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n",
                         2);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(problem_with(mesh), "accepted");
  EXPECT_NEAR(volume(mesh), 8, 1e-6);
}

TEST_F(MeshFile, TrianglesWithoutAnEdgeAreDropped) {
  auto box = box_mesh(size_in_cm);
  box.triangles.push_back({0, 0, 1});
  EXPECT_EQ(read(".stl", as_stl(box)).triangles.size(), 12U);
}

TEST_F(MeshFile, FilesThatAreNoMeshesAreRefused) {
  EXPECT_THROW((void)read_triangle_mesh("no/such/file.obj", 1), std::runtime_error);
  EXPECT_THROW((void)read_triangle_mesh(::testing::TempDir(), 1), std::runtime_error);
  for (const auto& [ending, content] : {std::pair{".stl", "nothing of the kind"},
                                        {".ply", "ply\nformat"},
                                        {".obj", "v 1 2 3\n"},
                                        {".txt", "v 1 2 3\n"}}) {
    try {
      (void)read(ending, content);
      ADD_FAILURE() << ending << " was accepted";
    } catch (const std::invalid_argument& problem) {
      EXPECT_EQ(std::string(problem.what()).find(file_.string() + ": "), 0U) << problem.what();
    }
    TearDown();
  }
  EXPECT_THROW((void)read(".obj", as_obj(box_mesh(size_in_cm)), 0), std::invalid_argument);
}

TEST(TriangleMesh, VolumeAndBoundsAreThoseOfTheBody) {
  EXPECT_NEAR(volume(box_mesh({2, 3, 4})), 24, 1e-12);
  EXPECT_NEAR(volume(turned_over(box_mesh({2, 3, 4}))), -24, 1e-12);
  EXPECT_TRUE(bounds(box_mesh({2, 3, 4})).min().isApprox(Vector3(-1, -1.5, -2)));
  // of second order in the facets, of which those of 4 halvings are short of the sphere by 0.292/4⁴ at most
  EXPECT_NEAR(volume(ball_mesh(1, 4)), 4 * std::numbers::pi / 3, 3 * 0.292 / 256 * 4 * std::numbers::pi / 3);
  EXPECT_TRUE(bounds(TriangleMesh{}).isEmpty());
  EXPECT_EQ(volume(TriangleMesh{}), 0);
}

TEST(TriangleMesh, ClosedSurfacesAreAcceptedEvenInsideOut) {
  for (const auto& mesh : {box_mesh({1, 1, 1}), ball_mesh(1, 2), torus_mesh(2, 1, 20, 10)}) {
    EXPECT_EQ(problem_with(mesh), "accepted");
    EXPECT_EQ(problem_with(turned_over(mesh)), "accepted");
  }
}

TEST(TriangleMesh, HolesAreCountedAndPlaced) {
  auto mesh = box_mesh({2, 2, 2});
  mesh.triangles.pop_back();  // of the top: vertices 4, 7, 6
  const auto problem = problem_with(mesh);
  EXPECT_TRUE(says(problem, "the mesh is open: 3 edges have one triangle only, e.g. at (")) << problem;
  EXPECT_TRUE(says(problem, ", 1) m; obstacles must be watertight")) << problem;
}

TEST(TriangleMesh, SurfacesThatBranchAreRefused) {
  auto mesh = box_mesh({2, 2, 2});
  mesh.vertices.emplace_back(0, 0, 3);
  const int tip = 8;  // a fin with two sides along the edge from 4 to 5
  mesh.triangles.push_back({4, 5, tip});
  mesh.triangles.push_back({5, 4, tip});
  const auto problem = problem_with(mesh);
  EXPECT_TRUE(says(problem, "the mesh branches: 1 edge has more than two triangles, e.g. at (0, -1, 1) m")) << problem;
}

TEST(TriangleMesh, NeighboursMustAgreeOnInsideAndOutside) {
  auto mesh = box_mesh({2, 2, 2});
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_TRUE(says(problem_with(mesh), "3 edges have neighbours that face opposite ways")) << problem_with(mesh);
}

TEST(TriangleMesh, WhatHasNoBodyIsRefused) {
  EXPECT_TRUE(says(problem_with({}), "no triangles"));
  EXPECT_TRUE(says(problem_with(box_mesh({1, 1, 0})), "no volume"));
  auto mesh = box_mesh({1, 1, 1});
  mesh.vertices[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(problem_with(mesh), "1 of 8 vertices are no finite numbers, vertex 5"));
  mesh = box_mesh({1, 1, 1});
  mesh.triangles[2][1] = 8;
  EXPECT_TRUE(says(problem_with(mesh), "triangle 2 names"));
  mesh.triangles[2][1] = mesh.triangles[2][0];
  EXPECT_TRUE(says(problem_with(mesh), "triangle 2 names a vertex twice"));
}

}  // namespace
}  // namespace sundrape

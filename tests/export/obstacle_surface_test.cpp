#include "sundrape/export/obstacle_surface.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sundrape/force/obstacle_box.hpp"
#include "sundrape/force/obstacle_capsule.hpp"
#include "sundrape/force/obstacle_cylinder.hpp"
#include "sundrape/force/obstacle_pedestal.hpp"
#include "sundrape/force/obstacle_sphere.hpp"
#include "sundrape/io/file_error.hpp"

namespace sundrape {
namespace {

constexpr double pi = std::numbers::pi;

ShadedSurface surface_of(const std::string& kind, std::map<std::string, std::vector<double>> parameters) {
  return obstacle_surface({.name = "body", .kind = kind, .parameters = std::move(parameters)}, {Vector3::Zero(), 1});
}

/// By the divergence theorem; of a closed surface that runs counter-clockwise seen from outside.
double volume(const ShadedSurface& s) {
  double sum = 0;
  for (const auto& [i, j, k] : s.triangles) {
    const auto at = [&](int n) -> const Vector3& { return s.vertices[static_cast<std::size_t>(n)]; };
    sum += at(i).dot(at(j).cross(at(k))) / 6;
  }
  return sum;
}

/// Normals are unit and those of the triangles, up to half the turn between facets; degenerate triangles at poles
/// apart.
void expect_outward(const ShadedSurface& s) {
  for (const auto& n : s.normals) EXPECT_NEAR(n.norm(), 1, 1e-12);
  for (const auto& triangle : s.triangles) {
    const auto at = [&](std::size_t c) { return static_cast<std::size_t>(triangle[c]); };
    const Vector3 area = (s.vertices[at(1)] - s.vertices[at(0)]).cross(s.vertices[at(2)] - s.vertices[at(0)]);
    if (area.norm() < 1e-9 * 1e-4) continue;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_GT(area.normalized().dot(s.normals[at(c)]), std::cos(0.14));
  }
}

struct Sample {
  std::string kind;
  std::map<std::string, std::vector<double>> parameters;
  double volume;
};

// Facets of 3.75° lose 1 − sin(2π/96)/(2π/96) = 7e-4 of a circle's area, and as much again of a sphere's outline.
constexpr double facets = 2e-3;

TEST(ObstacleSurface, EnclosesTheBodysVolumeWithNormalsOutwards) {
  const double r = 0.02, l = 0.05, e = 0.004;
  // a rounded drum: the inner drum, a ring of half discs about it (Pappus), by r − e
  const auto rounded_drum = [&](double height) {
    const double inner = r - e;
    const double ring = pi * e * e / 4, centroid = 4 * e / (3 * pi);
    return pi * inner * inner * height + 2 * pi * (inner + e / 2) * e * (height - 2 * e) +
           2 * 2 * pi * (inner + centroid) * ring;
  };
  const std::vector<Sample> samples{
      {"sphere", {{"radius", {r}}}, 4 * pi * r * r * r / 3},
      {"capsule", {{"radius", {r}}, {"length", {l}}}, 4 * pi * r * r * r / 3 + pi * r * r * l},
      {"capsule", {{"radius", {r}}, {"length", {l}}, {"axis", {1, 2, 3}}}, 4 * pi * r * r * r / 3 + pi * r * r * l},
      {"cylinder", {{"radius", {r}}, {"length", {l}}, {"edge_radius", {0}}}, pi * r * r * l},
      {"cylinder", {{"radius", {r}}, {"length", {l}}, {"edge_radius", {e}}}, rounded_drum(l)},
      {"disc", {{"radius", {r}}, {"height", {l}}}, pi * r * r * l},
      {"disc", {{"radius", {r}}, {"height", {l}}, {"edge_radius", {e}}}, rounded_drum(l)},
      {"box", {{"size", {0.02, 0.03, 0.04}}}, 0.02 * 0.03 * 0.04},
      {"box",
       {{"size", {0.02, 0.03, 0.04}}, {"edge_radius", {e}}},
       // inner box, slabs on its faces, quarter cylinders at its edges, a ball at its corners
       0.012 * 0.022 * 0.032 + 2 * e * (0.012 * 0.022 + 0.022 * 0.032 + 0.012 * 0.032) +
           pi * e * e * (0.012 + 0.022 + 0.032) + 4 * pi * e * e * e / 3}};
  for (const auto& sample : samples) {
    const auto surface = surface_of(sample.kind, sample.parameters);
    EXPECT_NEAR(volume(surface) / sample.volume, 1, facets) << sample.kind;
    expect_outward(surface);
  }
}

TEST(ObstacleSurface, LiesWhereContactHasTheBody) {
  const auto expect_on = [](const ShadedSurface& surface, const Obstacle& body) {
    for (const auto& vertex : surface.vertices) EXPECT_NEAR(body.distance(vertex).gap, 0, 1e-12);
  };
  expect_on(surface_of("sphere", {{"radius", {0.02}}}), SphereObstacle(0.02));
  expect_on(surface_of("capsule", {{"radius", {0.02}}, {"length", {0.05}}}), CapsuleObstacle(0.02, 0.05));
  expect_on(surface_of("cylinder", {{"radius", {0.02}}, {"length", {0.05}}, {"edge_radius", {0.004}}}),
            CylinderObstacle(0.02, 0.05, 0.004));
  expect_on(surface_of("disc", {{"radius", {0.02}}, {"height", {0.05}}, {"edge_radius", {0.004}}}),
            PedestalObstacle(0.02, 0.05, 0.004));
  expect_on(surface_of("box", {{"size", {0.02, 0.03, 0.04}}, {"edge_radius", {0.004}}}),
            BoxObstacle({0.02, 0.03, 0.04}, 0.004));
}

TEST(ObstacleSurface, OfAPlaneIsASquareAboutTheFootOfAPoint) {
  const Vector3 normal = Vector3(1, 2, 2) / 3, about(0.3, 0.1, 0.7);
  const auto s = obstacle_surface(
      {.name = "wall", .kind = "plane", .parameters = {{"point", {0, 0, 0.5}}, {"normal", {1, 2, 2}}}}, {about, 0.4});
  Vector3 middle = Vector3::Zero();
  for (const auto& v : s.vertices) {
    EXPECT_NEAR(normal.dot(v - Vector3(0, 0, 0.5)), 0, 1e-15);
    middle += v / 4;
  }
  EXPECT_LT(normal.cross(about - middle).norm(), 1e-15);
  EXPECT_NEAR((s.vertices[1] - s.vertices[0]).norm(), 0.8, 1e-15);
  expect_outward(s);
}

TEST(ObstacleSurface, OfAFileIsShadedFlatAtSharpEdges) {
  ObstacleRecord cube;
  cube.kind = "mesh";
  for (const double z : {0, 1})
    for (const double y : {0, 1})
      for (const double x : {0, 1}) cube.surface.vertices.emplace_back(x, y, z);
  cube.surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                            {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const auto s = obstacle_surface(cube, {});
  EXPECT_EQ(s.vertices.size(), 24U);  // each corner once for each of its faces
  EXPECT_NEAR(volume(s), 1, 1e-15);
  expect_outward(s);
}

TEST(ObstacleSurface, SaysWhatItDoesNotKnow) {
  EXPECT_THROW(static_cast<void>(surface_of("torus", {})), FileError);
  EXPECT_THROW(static_cast<void>(surface_of("sphere", {})), FileError);
}

}  // namespace
}  // namespace sundrape

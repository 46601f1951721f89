#include "sundrape/force/obstacle_mesh.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sundrape/force/obstacle_box.hpp"
#include "sundrape/force/obstacle_contact.hpp"

#include "support/force_term_checks.hpp"
#include "support/random_points.hpp"
#include "support/triangle_meshes.hpp"

namespace sundrape {
namespace {

constexpr double mm = 1e-3, um = 1e-6;

void expect_exact_derivatives(const Obstacle& body, const Vector3& x) {
  constexpr double step = um;
  const auto at = body.distance(x);
  EXPECT_EQ(at.curvature, at.curvature.transpose());
  for (int k = 0; k < 3; ++k) {
    const auto ahead = body.distance(x + step * Vector3::Unit(k)), behind = body.distance(x - step * Vector3::Unit(k));
    // the third derivative of the spline is up to some 2/h² next to edges, hence step²/h² and step/h
    EXPECT_NEAR((ahead.gap - behind.gap) / (2 * step), at.normal[k], 1e-6);
    EXPECT_LT(((ahead.normal - behind.normal) / (2 * step) - at.curvature.col(k)).norm(), 2e-3 / mm);
  }
}

TEST(MeshObstacle, BallIsTheExactOneToItsFacetsAndVoxels) {
  constexpr double radius = 20 * mm, facets = 0.292 * radius / 1024;  // 5.7 µm
  const auto mesh = ball_mesh(radius, 5);
  for (const double h : {1 * mm, 2 * mm}) {
    const MeshObstacle ball(mesh, h);
    const double smoothing = h * h / (3 * radius);  // 17 and 67 µm
    samples::RandomPoints points(1);
    for (int i = 0; i < 2000; ++i) {
      const Vector3 outwards = points.direction();
      const auto d = ball.distance(radius * outwards);
      // the next term of the smoothing is of the order (h/radius)²
      EXPECT_GT(d.gap, (1 - 2 * h / radius) * smoothing);
      EXPECT_LT(d.gap, (1 + 2 * h / radius) * smoothing + facets);
      // normals of facets differ from the ball's by up to their circumradius over its radius, 0.764/32, before
      // smoothing
      EXPECT_NEAR(d.normal.norm(), 1, 5e-3);
      EXPECT_LT((d.normal - outwards).norm(), 0.764 / 32);
      // facets bend the field by as much as they lie short of the ball, within the four voxels of the spline
      const Matrix3 curvature = (Matrix3::Identity() - outwards * outwards.transpose()) / radius;
      EXPECT_LT((d.curvature - curvature).norm(), 0.05 * curvature.norm() + 4 * facets / (h * h));
    }
  }
}

TEST(MeshObstacle, BoxHasFlatFacesWhereTheMeshHasThemAndRoundEdges) {
  constexpr double h = 1 * mm;
  const Vector3 half(20.3 * mm, 16 * mm, 12.5 * mm);
  const MeshObstacle box(box_mesh(2 * half), h);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (const double height : {-3 * mm, -0.02 * mm, 0.0, 0.02 * mm, 1.9 * mm}) {
        samples::RandomPoints points(3);
        for (int i = 0; i < 50; ++i) {
          // the spline looks two voxels aside and two deep, and edges are nearer than the face beyond their bisectors
          Vector3 x = (half.array() - 4 * h - std::max(0.0, -height)).matrix().cwiseProduct(points.in_cube(1));
          x[axis] = side * (half[axis] + height);
          const auto d = box.distance(x);
          EXPECT_NEAR(d.gap, height, 1e-12);
          EXPECT_LT((d.normal - side * Vector3::Unit(axis)).norm(), 1e-9);
          EXPECT_LT(d.curvature.norm(), 1e-6);
        }
      }
  const auto edge = box.distance({half.x(), half.y(), 0}), corner = box.distance(half);
  // over all places of an edge or a corner between the points of a grid: 0.29 h to 0.37 h and 0.45 h to 0.57 h
  EXPECT_GT(edge.gap, 0.28 * h);
  EXPECT_LT(edge.gap, 0.38 * h);
  EXPECT_GT(edge.normal.norm(), 0.7);
  EXPECT_LT((edge.normal.normalized() - Vector3(1, 1, 0).normalized()).norm(), 0.2);
  EXPECT_GT(corner.gap, 0.44 * h);
  EXPECT_LT(corner.gap, 0.58 * h);
}

TEST(MeshObstacle, NothingSticksOutOfTheBoxAround) {
  const Vector3 half(9 * mm, 7.3 * mm, 5 * mm);
  const MeshObstacle box(box_mesh(2 * half), 1 * mm);
  EXPECT_TRUE(box.bounds().max().isApprox(half));
  const BoxObstacle sharp(2 * half, 0);
  samples::RandomPoints points(4);
  for (int i = 0; i < 20000; ++i) {
    const Vector3 x = points.in_cube(12 * mm);
    const Vector3 beyond = x.cwiseAbs() - half;
    if (beyond.maxCoeff() < 2 * mm) {
      EXPECT_GT(box.distance(x).gap, beyond.maxCoeff() - 1e-12);
      EXPECT_NEAR(box.distance(x).gap, sharp.distance(x).gap, 0.58 * mm);
    }
  }
}

TEST(MeshObstacle, RingHasAHoleAndBendsBothWays) {
  constexpr double radius = 20 * mm, section = 8 * mm, h = 1 * mm;
  const MeshObstacle ring(torus_mesh(radius, section, 160, 64), h);
  // facets lie within section (1 − cos(π/64)) + (radius + section)(1 − cos(π/160)) = 15 µm of the ring
  const double facets = 15 * um;
  const auto exact = [&](const Vector3& x) { return std::hypot(std::hypot(x.x(), x.y()) - radius, x.z()) - section; };
  EXPECT_NEAR(ring.distance({0, 0, 0}).gap, 6 * h, 1e-15);  // the band
  samples::RandomPoints points(5);
  int checked = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3 x = points.in_cube(30 * mm);
    if (std::abs(exact(x)) > 2 * mm) continue;
    ++checked;
    const double axis = std::hypot(x.x(), x.y()), to_core = exact(x) + section;
    const double bend = 1 / to_core + (1 - radius / axis) / to_core;  // Laplacian of the distance
    EXPECT_NEAR(ring.distance(x).gap, exact(x) + h * h / 6 * bend, facets + 3 * um);
  }
  EXPECT_GT(checked, 400);
}

TEST(MeshObstacle, NormalIsTheGradientAndCurvatureTheHessianEverywhere) {
  samples::RandomPoints points(6);
  for (const auto& mesh : {box_mesh({20 * mm, 16 * mm, 12.6 * mm}), torus_mesh(12 * mm, 5 * mm, 24, 12)}) {
    const MeshObstacle body(mesh, 1 * mm);
    for (int i = 0; i < 500; ++i) expect_exact_derivatives(body, points.in_cube(20 * mm));
  }
}

TEST(MeshObstacle, ContactWithItConservesEnergyAndHasAnExactTangent) {
  constexpr double smoothing = 0.3 * mm;
  const auto body = std::make_shared<MeshObstacle>(box_mesh({20 * mm, 16 * mm, 12.6 * mm}), 1 * mm);
  std::vector<Vector3> nodes;
  samples::RandomPoints points(7);
  while (nodes.size() < 40) {
    const Vector3 x = points.in_cube(11 * mm);
    if (std::abs(body->distance(x).gap) < smoothing) nodes.push_back(x);
  }
  const ObstacleContact contact({{body}}, contact_points(std::vector<double>(nodes.size(), 1e-4)), {4e6, smoothing});
  expect_consistent(contact, perturbed(nodes, 0, 0, 1), 1e-5);
}

TEST(MeshObstacle, DeepInsideIsDownToTheMedialAxisAndFarOutsideIsTheBand) {
  constexpr double radius = 20 * mm;
  for (const auto& mesh : {ball_mesh(radius, 4), turned_over(ball_mesh(radius, 4))}) {
    const MeshObstacle ball(mesh, 1 * mm, 6 * mm);
    samples::RandomPoints points(8);
    for (int i = 0; i < 300; ++i) {
      const Vector3 outwards = points.direction();
      for (const double depth : {2 * mm, 7 * mm, 12 * mm, 16 * mm}) {
        // facets, and the freedom of the search at depth
        const auto d = ball.distance((radius - depth) * outwards);
        EXPECT_NEAR(d.gap, -depth, 0.2 * mm);
        EXPECT_GT(d.normal.dot(outwards), 0.9);
      }
      EXPECT_NEAR(ball.distance((radius + 3.9 * mm) * outwards).gap, 3.9 * mm, 0.1 * mm);
      for (const double height : {9.5 * mm, 20 * mm, 1.0, 1e9}) {
        const auto d = ball.distance((radius + height) * outwards);
        EXPECT_NEAR(d.gap, 6 * mm, 1e-15);
        EXPECT_NEAR(d.normal.norm(), 0, 1e-12);
        EXPECT_NEAR(d.curvature.norm(), 0, 1e-9);
      }
    }
    EXPECT_NEAR(ball.distance(Vector3::Zero()).gap, -radius, 1.1 * mm);
  }
}

TEST(MeshObstacle, BodiesThatOverlapAreOne) {
  auto mesh = box_mesh({20 * mm, 10 * mm, 10 * mm});
  const auto other = box_mesh({10.4 * mm, 20 * mm, 9.2 * mm});
  for (const auto& x : other.vertices) mesh.vertices.push_back(x);
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + 8, b + 8, c + 8});
  const MeshObstacle cross(mesh, 1 * mm);
  EXPECT_LT(cross.distance(Vector3::Zero()).gap, -3 * mm);
  EXPECT_NEAR(cross.distance({8 * mm, 0, 6 * mm}).gap, 1 * mm, 1e-12);
  EXPECT_NEAR(cross.distance({0, 8 * mm, 5.6 * mm}).gap, 1 * mm, 1e-12);
}

TEST(MeshObstacle, MirroredBodiesHaveMirroredFields) {
  const MeshObstacle body(box_mesh({20 * mm, 16 * mm, 12.6 * mm}), 0.93 * mm);
  samples::RandomPoints points(9);
  for (int i = 0; i < 300; ++i) {
    const Vector3 x = points.in_cube(11 * mm), mirrored = x.cwiseProduct(Vector3(-1, 1, -1));
    EXPECT_NEAR(body.distance(x).gap, body.distance(mirrored).gap, 1e-15);
  }
}

TEST(MeshObstacle, SaysHowFarItRoundsTheMeshOff) {
  const double corner = MeshObstacle(box_mesh({40 * mm, 40 * mm, 40 * mm}), mm).rounding();
  EXPECT_GT(corner, 0.45 * mm);  // a gap of 0.45 to 0.57 h, where the normal is shorter than 1
  EXPECT_LT(corner, mm);
  // a thin plate across a block: its grid cannot show it
  auto finned = box_mesh({40 * mm, 40 * mm, 40 * mm});
  const auto fin = box_mesh({50 * mm, 40 * mm, 0.6 * mm});
  for (auto triangle : fin.triangles) {
    for (int& vertex : triangle) vertex += static_cast<int>(finned.vertices.size());
    finned.triangles.push_back(triangle);
  }
  finned.vertices.insert(finned.vertices.end(), fin.vertices.begin(), fin.vertices.end());
  EXPECT_GT(MeshObstacle(finned, 2 * mm).rounding(), 4 * mm);
  EXPECT_LT(MeshObstacle(finned, 0.3 * mm).rounding(), mm) << "two voxels thick";
}

TEST(MeshObstacle, ImpossibleVoxelsAndMeshesAreRefused) {
  const auto box = box_mesh({100 * mm, 80 * mm, 20 * mm});
  const auto problem = [&](const TriangleMesh& mesh, double voxel_size) -> std::string {
    try {
      const MeshObstacle body(mesh, voxel_size);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "accepted";
  };
  for (const double size : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(MeshObstacle(box, size), std::invalid_argument);
  EXPECT_THROW(MeshObstacle(box, 1 * mm, 3 * mm), std::invalid_argument);
  EXPECT_THROW(MeshObstacle(box, 1 * mm, std::nan("")), std::invalid_argument);
  EXPECT_EQ(problem(box, 5 * mm), "accepted");
  EXPECT_EQ(problem(box, 6 * mm),
            "voxels of 6 mm are too coarse for a body of 100 mm × 80 mm × 20 mm: between 0.148 mm (500 MB) and 5 mm (4 "
            "voxels across) will do");
  EXPECT_NE(problem(box, 0.1 * mm).find("too fine"), std::string::npos);
  EXPECT_NE(problem(box_mesh({10, 10, 1 * mm}), 1 * mm).find("no others would do"), std::string::npos);
  auto open = box;
  open.triangles.pop_back();
  EXPECT_NE(problem(open, 1 * mm).find("watertight"), std::string::npos);
}

}  // namespace
}  // namespace sundrape

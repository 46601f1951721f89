#include "sundrape/app/obstacles.hpp"

#include "sundrape/app/model.hpp"
#include "sundrape/force/obstacle_box.hpp"
#include "sundrape/force/obstacle_capsule.hpp"
#include "sundrape/force/obstacle_cylinder.hpp"
#include "sundrape/force/obstacle_mesh.hpp"
#include "sundrape/force/obstacle_pedestal.hpp"
#include "sundrape/force/obstacle_plane.hpp"
#include "sundrape/force/obstacle_sphere.hpp"
#include "sundrape/io/case_error.hpp"

namespace sundrape {
namespace {

struct Shape {
  std::unique_ptr<const Obstacle> obstacle;
  std::string kind;
  std::map<std::string, std::vector<double>> parameters;
  Matrix3 own_rotation = Matrix3::Identity();  // of a shape along z to the axis that the case gives
  TriangleMesh surface = {};
};

std::vector<double> list(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Shape shape(const PlaneShape& s) {
  return {std::make_unique<PlaneObstacle>(s.point, s.normal),
          "plane",
          {{"point", list(s.point)}, {"normal", list(s.normal)}}};
}
Shape shape(const BoxShape& s) {
  return {std::make_unique<BoxObstacle>(s.size, s.edge_radius),
          "box",
          {{"size", list(s.size)}, {"edge_radius", {s.edge_radius}}}};
}
Shape shape(const SphereShape& s) {
  return {std::make_unique<SphereObstacle>(s.radius), "sphere", {{"radius", {s.radius}}}};
}
Shape shape(const CylinderShape& s) {
  return {std::make_unique<CylinderObstacle>(s.radius, s.length, s.edge_radius),
          "cylinder",
          {{"radius", {s.radius}}, {"length", {s.length}}, {"edge_radius", {s.edge_radius}}, {"axis", {0, 0, 1}}},
          rotation_of_z_to(s.axis)};
}
Shape shape(const CapsuleShape& s) {
  return {std::make_unique<CapsuleObstacle>(s.radius, s.length),
          "capsule",
          {{"radius", {s.radius}}, {"length", {s.length}}, {"axis", {0, 0, 1}}},
          rotation_of_z_to(s.axis)};
}
Shape shape(const DiscPedestalShape& s) {
  return {std::make_unique<PedestalObstacle>(s.radius, s.height, s.edge_radius),
          "disc",
          {{"radius", {s.radius}}, {"height", {s.height}}, {"edge_radius", {s.edge_radius}}}};
}

/// A body of a file, which a viewer gets as it is there.
Shape shape(const MeshBodyShape& s) {
  constexpr double voxels_across = 64;
  try {
    auto mesh = read_triangle_mesh(s.file, s.unit);
    check_closed(mesh);
    const double voxel = s.voxel.value_or(bounds(mesh).sizes().maxCoeff() / voxels_across);
    auto obstacle = std::make_unique<MeshObstacle>(mesh, voxel);
    const double rounding = obstacle->rounding();
    Shape body{std::move(obstacle), "mesh", {{"voxel", {voxel}}, {"rounding", {rounding}}}};
    body.surface = std::move(mesh);
    return body;
  } catch (const std::exception& problem) {
    throw CaseError(s.source, problem.what());
  }
}

}  // namespace

PathCourse course_of(const PathCase& path) {
  return {path.path,
          {.start = path.start,
           .duration = path.duration.value_or(0),
           .profile = path.smooth ? PathTiming::Profile::smooth : PathTiming::Profile::linear,
           .stages = path.stages}};
}

BuiltObstacle build_obstacle(const ObstacleCase& c) {
  try {
    Shape s = std::visit([](const auto& given) { return shape(given); }, c.shape);
    auto stands = placement(c.place);
    stands.rotation *= s.own_rotation;
    ObstacleRecord record{.name = c.name,
                          .kind = s.kind,
                          .parameters = s.parameters,
                          .position = stands.translation,
                          .rotation = stands.rotation,
                          .friction = c.friction,
                          .moves = c.motion.has_value(),
                          .surface = std::move(s.surface)};
    std::optional<PathCourse> course;
    if (c.motion) course = course_of(*c.motion);
    return {{std::make_shared<PlacedObstacle>(std::move(s.obstacle), stands), c.friction, std::move(course)},
            std::move(record)};
  } catch (const std::invalid_argument& problem) {
    throw CaseError(c.source, problem.what());
  }
}

}  // namespace sundrape

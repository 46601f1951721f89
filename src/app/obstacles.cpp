#include "sundrape/app/obstacles.hpp"

#include "sundrape/app/model.hpp"
#include "sundrape/force/obstacle_box.hpp"
#include "sundrape/force/obstacle_capsule.hpp"
#include "sundrape/force/obstacle_cylinder.hpp"
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

}  // namespace

BuiltObstacle build_obstacle(const ObstacleCase& c) {
  try {
    Shape s = std::visit([](const auto& given) { return shape(given); }, c.shape);
    auto stands = placement(c.place);
    stands.rotation *= s.own_rotation;
    ObstacleRecord record{.name = c.name,
                          .kind = s.kind,
                          .parameters = s.parameters,
                          .position = stands.translation,
                          .rotation = stands.rotation};
    return {std::make_shared<PlacedObstacle>(std::move(s.obstacle), stands), std::move(record)};
  } catch (const std::invalid_argument& problem) {
    throw CaseError(c.source, problem.what());
  }
}

}  // namespace sundrape

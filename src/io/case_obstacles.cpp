#include <algorithm>

#include <fmt/format.h>

#include "case_parts.hpp"

namespace sundrape {
namespace {

/// @param smallest  the body's smallest size [m]
double resolve_edge_radius(const CaseSection& obstacle, double smallest) {
  const double radius = obstacle.number("edge_radius");
  if (radius > smallest / 2)
    obstacle.fail("edge_radius", fmt::format("{:.10g} m is outside [0, {:.10g}] m: at most half the smallest size",
                                             radius, smallest / 2));
  return radius;
}

ObstacleCase resolve_obstacle(const CaseSection& section, Analysis analysis, const std::filesystem::path& folder) {
  ObstacleCase obstacle;
  obstacle.source = section.source();
  obstacle.place = resolve_place(section.table("place"));
  const std::string kind = section.text("kind");
  if (kind == "plane") {
    obstacle.shape = PlaneShape{section.vector3("point"), section.direction("normal")};
  } else if (kind == "box") {
    const Vector3 size = section.vector3("size");
    obstacle.shape = BoxShape{size, resolve_edge_radius(section, size.minCoeff())};
  } else if (kind == "cylinder") {
    const double radius = section.number("radius");
    const double length = section.number("length");
    obstacle.shape = CylinderShape{radius, length, section.direction("axis"),
                                   resolve_edge_radius(section, std::min(2 * radius, length))};
  } else if (kind == "sphere") {
    obstacle.shape = SphereShape{section.number("radius")};
  } else if (kind == "capsule") {
    obstacle.shape = CapsuleShape{section.number("radius"), section.number("length"), section.direction("axis")};
  } else if (kind == "mesh") {
    obstacle.shape = MeshBodyShape{file_beside(section, "file", folder), section.unit("units"),
                                   section.maybe_number("voxel"), section.source("file")};
  } else {
    const double radius = section.number("radius");
    const double height = section.number("height");
    obstacle.shape = DiscPedestalShape{radius, height, resolve_edge_radius(section, std::min(2 * radius, height))};
  }
  obstacle.friction = section.number("friction");
  if (section.has("motion")) {
    const auto motion = section.table("motion");
    obstacle.motion = resolve_course(motion, analysis);
    obstacle.motion->stages = motion.series("stages");
  }
  return obstacle;
}

}  // namespace

std::vector<ObstacleCase> resolve_obstacles(const std::vector<CaseSection>& sections, Analysis analysis,
                                            const std::filesystem::path& folder) {
  std::vector<ObstacleCase> obstacles;
  for (const auto& section : sections) {
    ObstacleCase obstacle = resolve_obstacle(section, analysis, folder);
    obstacle.name =
        section.has("name") ? section.text("name") : fmt::format("{}{}", section.text("kind"), obstacles.size());
    for (const auto& earlier : obstacles)
      if (earlier.name == obstacle.name)
        section.fail("name", fmt::format("'{}' is already the name of {}", obstacle.name, earlier.source.key));
    obstacles.push_back(std::move(obstacle));
  }
  return obstacles;
}

ContactCase resolve_contact(const CaseSection& section, double thickness, bool layers) {
  ContactCase contact;
  contact.self = section.has("self") ? section.boolean("self") : layers;
  contact.thickness_given = section.has("thickness");
  contact.friction = section.number("friction");
  contact.thickness = section.maybe_number("thickness").value_or(thickness);
  contact.stiffness = section.maybe_number("stiffness");
  contact.smoothing = section.maybe_number("smoothing").value_or(0.1 * contact.thickness);
  contact.penetration = section.maybe_number("penetration").value_or(0.1 * contact.thickness);
  if (contact.self && !(contact.smoothing < contact.thickness))
    section.fail("smoothing",
                 fmt::format("{:.4g} m is not less than contact.thickness = {:.4g} m, as cloth that touches "
                             "cloth needs it",
                             contact.smoothing, contact.thickness));
  contact.restitution = section.maybe_number("restitution");
  contact.friction_speed = section.number("friction_speed");
  contact.restitution_speed = section.number("restitution_speed");
  contact.subdivision = section.integer("subdivision");
  if (contact.restitution) {
    if (contact.self) section.fail("restitution", "impacts know obstacles only; leave one of it and contact.self out");
    if (section.has("subdivision") && contact.subdivision != 1)
      section.fail("subdivision", "impacts happen to nodes: with contact.restitution it can only be 1");
    contact.subdivision = 1;
  }
  return contact;
}

}  // namespace sundrape

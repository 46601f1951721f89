#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

Section obstacle() {
  return {
      .name = "obstacle",
      .heading = "`[[obstacle]]`",
      .kind_key = "kind",
      .doc = "Centred on its place. An edge radius is at most half the smallest size.",
      .keys =
          {
              {.name = "kind",
               .type = KeyType::choice,
               .choices = {"plane", "box", "cylinder", "sphere", "capsule", "disc", "mesh"},
               .required = true,
               .doc = "What sort of body; a disc is a pedestal."},
              {.name = "name", .type = KeyType::name, .default_note = "kind and index", .doc = "No two alike."},
              {.name = "place", .type = KeyType::table, .holds = "place", .doc = "Where it stands."},
              only_for({"plane"}, with_default(vector3("point", "m", "A point of the plane."), "[0, 0, 0]")),
              {.name = "normal",
               .type = KeyType::direction,
               .default_value = "[0, 0, 1]",
               .kinds = {"plane"},
               .doc = "Out of the solid side, of any length."},
              {.name = "size",
               .unit = "m",
               .scalar = false,
               .entries = 3,
               .range = positive(),
               .required = true,
               .kinds = {"box"},
               .doc = "Full edge lengths along x, y and z."},
              only_for({"cylinder", "sphere", "capsule", "disc"}, length("radius", "Its radius.")),
              only_for({"cylinder", "capsule"},
                       length("length", "Along the axis; a capsule's between the centres of its caps.")),
              {.name = "axis",
               .type = KeyType::direction,
               .default_value = "[0, 0, 1]",
               .kinds = {"cylinder", "capsule"},
               .doc = "Its axis, of any length."},
              {.name = "height",
               .unit = "m",
               .range = positive(),
               .default_value = "\"10 cm\"",
               .kinds = {"disc"},
               .doc = "Downwards from its top, which is z = 0 of its place."},
              {.name = "edge_radius",
               .unit = "m",
               .range = not_negative(),
               .default_value = "0",
               .kinds = {"box", "cylinder", "disc"},
               .doc = "Rounding of its edges."},
              mesh_file("A closed surface of triangles or polygons: OBJ, PLY or STL."),
              mesh_units(),
              {.name = "voxel",
               .unit = "m",
               .range = positive(),
               .default_note = "a 64th of its largest size",
               .kinds = {"mesh"},
               .doc = "Grid of the smooth distance that stands for the surface: edges come out rounded over it."},
              {.name = "friction",
               .range = not_negative(),
               .default_value = "0",
               .doc = "Coefficient of Coulomb's friction; it acts in dynamics only."},
              {.name = "motion", .type = KeyType::table, .holds = "obstacle.motion", .doc = "Its prescribed path."},
          },
  };
}

Section obstacle_motion() {
  auto keys = path_keys();
  keys.push_back(stages("the path"));
  return {.name = "obstacle.motion",
          .heading = "`motion = { ... }` of `[[obstacle]]`",
          .kind_key = "kind",
          .doc = "From its place on, with the keys of a gripper's path.",
          .keys = std::move(keys)};
}

Section contact() {
  return {
      .name = "contact",
      .heading = "`[contact]`",
      .doc =
          "A penalty force between the cloth and obstacles, and between the cloth and itself, that sets in smoothly.",
      .keys =
          {
              {.name = "self",
               .type = KeyType::boolean,
               .default_note = "true of several sheets, else false",
               .doc = "Whether cloth touches cloth: else it passes through itself, and a run says so at its end."},
              {.name = "thickness",
               .unit = "m",
               .range = positive(),
               .default_note = "`material.thickness`",
               .doc =
                   "At what distance two layers of cloth lie on each other, and the scale of the two defaults below."},
              {.name = "friction",
               .range = not_negative(),
               .default_value = "0",
               .doc = "Coefficient of Coulomb's friction of cloth on cloth; it acts in dynamics only."},
              {.name = "stiffness",
               .unit = "N/m^3",
               .range = positive(),
               .default_note = "from the load and `penetration`",
               .doc = "Pressure per depth."},
              {.name = "subdivision",
               .type = KeyType::integer,
               .range = from_to(1, 10),
               .default_value = "2",
               .doc = "Contact points cut the sides of a cell into so many parts; 1: nodes alone, which `restitution` "
                      "demands."},
              {.name = "smoothing",
               .unit = "m",
               .range = positive(),
               .default_note = "0.1 `thickness`",
               .doc = "Distance over which the force sets in: above an obstacle's surface; between two layers half "
                      "of it above, half below the distance at which they lie on each other."},
              {.name = "penetration",
               .unit = "m",
               .range = positive(),
               .default_note = "0.1 `thickness`",
               .doc = "Depth allowed."},
              {.name = "restitution",
               .range = from_to(0, 1),
               .default_note = "no impact law",
               .doc = "Speed after an impact over the speed before."},
              {.name = "friction_speed",
               .unit = "m/s",
               .range = positive(),
               .default_value = "\"0.1 mm/s\"",
               .doc = "Cloth that friction holds creeps, at most so fast; above it friction has its full size. Ten "
                      "times more is cheaper where nothing has to rest."},
              {.name = "restitution_speed",
               .unit = "m/s",
               .range = positive(),
               .default_value = "0.05",
               .doc = "Slower impacts are left to the penalty force."},
          },
  };
}

}  // namespace

std::vector<Section> contact_keys() { return {obstacle(), obstacle_motion(), contact()}; }

}  // namespace sundrape

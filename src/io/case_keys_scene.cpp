#include <fmt/format.h>

#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

Key with_default(Key key, std::string value) {
  key.default_value = std::move(value);
  return key;
}

Key required(Key key) {
  key.required = true;
  return key;
}

Key only_for(std::vector<std::string> kinds, Key key) {
  key.kinds = std::move(kinds);
  return key;
}

Key nodes(std::vector<std::string> kinds = {}) {
  return {
      .name = "nodes", .type = KeyType::selector, .required = true, .kinds = std::move(kinds), .doc = "Which nodes."};
}

Key length(std::string name, std::string doc) {
  return {.name = std::move(name), .unit = "m", .range = positive(), .required = true, .doc = std::move(doc)};
}

Key stages(const std::string& what) {
  return {.name = "stages",
          .type = KeyType::series,
          .entries = 20,
          .default_value = "1",
          .doc = fmt::format("How much of {} there is at the end of each stage of `analysis = \"arc-length\"`, as a "
                             "share; after the last one it stays. Other analyses take the last.",
                             what)};
}

/// When a gripper closes and opens, after the keys of its section.
std::vector<Key> with_grip(std::vector<Key> keys) {
  keys.insert(
      keys.end(),
      {{.name = "grip",
        .unit = "s",
        .range = not_negative(),
        .default_note = "from the start",
        .doc = "Dynamics: the nodes are free until then, and held from where they are. Nodes chosen by a place are "
               "those that are there at that time (`near`: the closest one within the mean length of an edge); if "
               "there is none, the run stops. A path sets out then unless `start` says otherwise. Of a particle net "
               "`rotation` has to be held from the start."},
       {.name = "release", .unit = "s", .range = positive(), .default_note = "never", .doc = "Dynamics: let go."}});
  return keys;
}

Section motion() {
  return {
      .name = "motion",
      .heading = "`[[motion]]`",
      .doc =
          "Nodes that are held and carried along a path: over time in dynamics, through equilibria at chosen times in "
          "relaxation, in stages with `analysis = \"arc-length\"`. Several motions of one node follow each other.",
      .keys = with_grip({
          nodes(),
          {.name = "components",
           .type = KeyType::choices,
           .choices = {"x", "y", "z", "rotation"},
           .default_value = R"(["x", "y", "z"])",
           .doc = "What follows the path; the others are free, or held by a `[[fix]]`. With `rotation` the gripped "
                  "edge turns with the path, as in a jaw; without, it is a hinge."},
          {.name = "path", .type = KeyType::table, .holds = "motion.path", .required = true, .doc = "Where to."},
          stages("the path"),
          {.name = "name",
           .type = KeyType::name,
           .default_note = "from the selector",
           .doc = "Of its reaction in the result; no two alike."},
      }),
  };
}

/// Where a body is carried to, and when.
std::vector<Key> path_keys() {
  return {
      {.name = "kind",
       .type = KeyType::choice,
       .choices = {"arc", "line", "keyframes"},
       .required = true,
       .doc = "A turn about an axis, a translation, or both through given places at given times."},
      only_for({"arc"}, required(vector3("centre", "m", "A point of the axis."))),
      {.name = "axis",
       .type = KeyType::direction,
       .required = true,
       .kinds = {"arc"},
       .doc = "Of any length; turns follow the right hand."},
      {.name = "angle", .unit = "rad", .required = true, .kinds = {"arc"}, .doc = "Of the whole turn."},
      only_for({"line"}, required(vector3("by", "m", "The whole translation."))),
      only_for({"keyframes"},
               with_default(vector3("pivot", "m", "A point of the axis, before the translation."), "[0, 0, 0]")),
      {.name = "turn_axis",
       .type = KeyType::direction,
       .default_value = "[0, 0, 1]",
       .kinds = {"keyframes"},
       .doc = "Of the angles of the points."},
      {.name = "points",
       .type = KeyType::tables,
       .holds = "motion.path.points",
       .required = true,
       .kinds = {"keyframes"},
       .doc = "Where to be when, in the order of time; before them, at `start`, it is where it begins."},
      {.name = "start", .unit = "s", .range = not_negative(), .default_value = "0", .doc = "When it sets out."},
      {.name = "duration",
       .unit = "s",
       .range = positive(),
       .default_note = "none; dynamics needs one",
       .kinds = {"arc", "line"},
       .doc = "How long it takes."},
      {.name = "profile",
       .type = KeyType::choice,
       .choices = {"smooth", "linear"},
       .default_value = R"("smooth")",
       .doc = "`smooth` starts and stops with no jump in speed or acceleration, through keyframes on a cubic "
              "spline; `linear` goes at constant speed, from keyframe to keyframe, and jerks at its ends."},
  };
}

Section motion_path() {
  return {
      .name = "motion.path", .heading = "`path = { ... }` of `[[motion]]`", .kind_key = "kind", .keys = path_keys()};
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

Section motion_path_points() {
  return {
      .name = "motion.path.points",
      .heading = "`points = [ { ... } ]` of `path`",
      .keys = {
          {.name = "time", .unit = "s", .range = positive(), .required = true, .doc = "From the start of the path on."},
          with_default(vector3("by", "m", "Translation from where it begins."), "[0, 0, 0]"),
          {.name = "angle", .unit = "rad", .default_value = "0", .doc = "Turned by, from where it begins."}}};
}

Section fix() {
  return {
      .name = "fix",
      .heading = "`[[fix]]`",
      .doc = "Nodes held where they start. Supports that overlap add up.",
      .keys = with_grip({
          nodes(),
          {.name = "components",
           .type = KeyType::choices,
           .choices = {"x", "y", "z", "rotation", "director-x", "director-y", "director-z"},
           .default_value = R"(["x", "y", "z", "rotation"])",
           .doc = "What is held; `rotation` clamps the slope of a held edge, which is the whole director of a shell "
                  "node. `director-x` and so on hold one component of it, as on planes of symmetry and at hinges; "
                  "only with `model = \"shell\"`."},
          {.name = "name",
           .type = KeyType::name,
           .default_note = "from the selector",
           .doc = "Of its reaction in the result; no two alike."},
      }),
  };
}

Section selector() {
  return {
      .name = "selector",
      .heading = "`nodes = { ... }`",
      .doc = "Exactly one of these; geometry refers to the initial positions.",
      .keys =
          {
              vector3("near", "m", "The node closest to this point."),
              {.name = "box", .type = KeyType::corners, .unit = "m", .doc = "All nodes in `[[x, y, z], [x, y, z]]`."},
              {.name = "plane", .type = KeyType::table, .holds = "selector.plane", .doc = "All nodes on a plane."},
              {.name = "sphere", .type = KeyType::table, .holds = "selector.sphere", .doc = "All nodes in a ball."},
          },
  };
}

Section selector_plane() {
  return {
      .name = "selector.plane",
      .heading = "`nodes = { plane = { ... } }`",
      .keys = {required(vector3("point", "m", "A point of the plane.")),
               {.name = "normal", .type = KeyType::direction, .required = true, .doc = "Its normal, of any length."}}};
}

Section selector_sphere() {
  return {.name = "selector.sphere",
          .heading = "`nodes = { sphere = { ... } }`",
          .keys = {required(vector3("centre", "m", "Its centre.")), length("radius", "Its radius.")}};
}

Section load() {
  return {
      .name = "load",
      .heading = "`[[load]]`",
      .kind_key = "kind",
      .doc = "No load, not even gravity, unless the case says so.",
      .keys =
          {
              {.name = "kind",
               .type = KeyType::choice,
               .choices = {"gravity", "force", "moment", "traction", "pressure", "wind"},
               .required = true,
               .doc = "What sort of load."},
              only_for({"gravity"},
                       with_default(vector3("acceleration", "m/s^2", "Of free fall."), "[0, 0, -9.80665]")),
              nodes({"force", "moment", "traction"}),
              only_for({"force"}, required(vector3("total", "N", "Sum over the nodes, shared equally."))),
              only_for({"moment"},
                       required(vector3("total", "N m", "Sum over the nodes, shared by tributary length."))),
              only_for({"traction"}, required(vector3("per_length", "N/m", "Force per length of the edge."))),
              {.name = "value",
               .unit = "N/m^2",
               .required = true,
               .kinds = {"pressure"},
               .doc = "Along the normal of every face, which it follows."},
              only_for({"wind"}, with_default(vector3("velocity", "m/s", "Of the air, everywhere; zero: still air."),
                                              "[0, 0, 0]")),
              {.name = "density",
               .unit = "kg/m^3",
               .range = not_negative(),
               .default_value = "1.2",
               .kinds = {"wind"},
               .doc = "Of the air."},
              {.name = "drag",
               .range = not_negative(),
               .default_value = "1.2",
               .kinds = {"wind"},
               .doc = "Coefficient of a face across the flow."},
              {.name = "lift",
               .range = not_negative(),
               .default_value = "1",
               .kinds = {"wind"},
               .doc = "A face at the angle α to the flow has this times sin α cos α."},
              {.name = "gust",
               .type = KeyType::table,
               .holds = "gust",
               .kinds = {"wind"},
               .doc = "Changes of the velocity in time; dynamics only."},
              stages("the load"),
              {.name = "ramp",
               .unit = "s",
               .range = not_negative(),
               .default_value = "0",
               .doc = "Grows smoothly to its full size over this time; 0: there from the start."},
          },
  };
}

Section gust() {
  return {
      .name = "gust",
      .heading = "`gust = { ... }` of a `wind`",
      .doc = "Three waves of incommensurate periods with random phases.",
      .keys =
          {
              required(vector3("amplitude", "m/s", "Largest change of the velocity.")),
              {.name = "period",
               .unit = "s",
               .range = positive(),
               .default_value = "1",
               .doc = "Of the slowest wave; the others are 1.73 and 2.65 times as fast."},
              {.name = "seed",
               .type = KeyType::integer,
               .range = from_to(0, 4294967295.0),
               .default_value = "1",
               .doc = "Of the phases."},
          },
  };
}

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

std::vector<Section> scene_keys() {
  return {fix(),  motion(), motion_path(), motion_path_points(), selector(), selector_plane(), selector_sphere(),
          load(), gust(),   obstacle(),    obstacle_motion(),    contact()};
}

}  // namespace sundrape

#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

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

Section motion_path() {
  return {
      .name = "motion.path", .heading = "`path = { ... }` of `[[motion]]`", .kind_key = "kind", .keys = path_keys()};
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

}  // namespace

std::vector<Section> support_keys() {
  return {fix(), motion(), motion_path(), motion_path_points(), selector(), selector_plane(), selector_sphere()};
}

}  // namespace sundrape

#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

Section cloth() {
  return {
      .name = "cloth",
      .heading = "`[cloth]`, or `[[cloth]]` for several sheets",
      .kind_key = "shape",
      .doc = "The sheet at rest, flat in z = 0 unless it comes from a file, and where it starts.",
      .keys =
          {
              {.name = "shape",
               .type = KeyType::choice,
               .choices = {"rectangle", "disc", "annulus", "mesh"},
               .required = true,
               .doc = "Outline of the sheet; the centre of a rectangle, disc or annulus is the origin."},
              {.name = "name",
               .type = KeyType::name,
               .default_note = "`cloth`; of several sheets `cloth0`, `cloth1`, ...",
               .doc = "Of the sheet; the node set `left` of a sheet `top` alone is `top.left`, all of it `top`."},
              {.name = "material",
               .type = KeyType::table,
               .holds = "material",
               .default_note = "the case's `[material]`",
               .doc = "The sheet's own fabric, with all keys of `[material]`."},
              {.name = "size",
               .unit = "m",
               .scalar = false,
               .entries = 2,
               .range = positive(),
               .required = true,
               .kinds = {"rectangle"},
               .doc = "Edge lengths, warp direction (x) first."},
              {.name = "cells",
               .type = KeyType::integer,
               .scalar = false,
               .entries = 2,
               .range = from_to(1, 10000),
               .required = true,
               .kinds = {"rectangle"},
               .doc = "Quadrilaterals along warp and weft."},
              {.name = "radius",
               .unit = "m",
               .range = positive(),
               .required = true,
               .kinds = {"disc"},
               .doc = "Of the disc."},
              {.name = "cells",
               .type = KeyType::integer,
               .range = from_to(2, 10000),
               .required = true,
               .kinds = {"disc"},
               .doc = "Quadrilaterals across the diameter."},
              {.name = "inner_radius",
               .unit = "m",
               .range = positive(),
               .required = true,
               .kinds = {"annulus"},
               .doc = "Of the hole; smaller than `outer_radius`."},
              {.name = "outer_radius",
               .unit = "m",
               .range = positive(),
               .required = true,
               .kinds = {"annulus"},
               .doc = "Of the rim."},
              {.name = "cells",
               .type = KeyType::integer,
               .scalar = false,
               .entries = 2,
               .range = from_to(1, 10000),
               .required = true,
               .kinds = {"annulus"},
               .doc = "Quadrilaterals from hole to rim, and around (at least 3)."},
              mesh_file("A mesh of quadrilaterals (OBJ); its rest shape may be curved."),
              mesh_units(),
              {.name = "place", .type = KeyType::table, .holds = "place", .doc = "Rest position to initial position."},
              {.name = "start",
               .type = KeyType::file,
               .default_note = "the rest shape, placed",
               .doc = "A result on the same mesh: the cloth starts at rest where its last frame ends, but for what is "
                      "held. "
                      "Waviness comes on top if it is asked for."},
              {.name = "waviness",
               .type = KeyType::table,
               .holds = "waviness",
               .default_note = "flat in dynamics, a slight imperfection in relaxation",
               .doc = "Random imperfection of the initial position."},
          },
  };
}

Section place() {
  return {
      .name = "place",
      .heading = "`place = { ... }` of `[cloth]` and `[[obstacle]]`",
      .doc = "Rotation about the origin, then translation.",
      .keys =
          {
              {.name = "translate",
               .unit = "m",
               .scalar = false,
               .entries = 3,
               .default_value = "[0, 0, 0]",
               .doc = "By how much it is moved."},
              {.name = "rotate", .type = KeyType::table, .holds = "rotate", .doc = "About which axis and how far."},
          },
  };
}

Section rotate() {
  return {
      .name = "rotate",
      .heading = "`rotate = { ... }` of `place`",
      .keys =
          {
              {.name = "axis",
               .type = KeyType::direction,
               .default_value = "[0, 0, 1]",
               .doc = "Of any length; the rotation is right-handed about it."},
              {.name = "angle", .unit = "rad", .required = true, .doc = "How far, e.g. `\"90 deg\"`."},
          },
  };
}

Section waviness() {
  return {
      .name = "waviness",
      .heading = "`waviness = { ... }` of `[cloth]`",
      .doc =
          "Every node starts off the rest surface by a random distance, uniform between plus and minus the amplitude.",
      .keys =
          {
              {.name = "amplitude", .unit = "m", .range = not_negative(), .required = true, .doc = "Largest distance."},
              {.name = "seed",
               .type = KeyType::integer,
               .range = from_to(0, 4294967295.0),
               .default_value = "1",
               .doc = "Of the random numbers: the same seed gives the same sheet."},
              {.name = "at_rest",
               .type = KeyType::boolean,
               .default_note = "true with `analysis = \"arc-length\"`, else false",
               .doc =
                   "Whether the cloth was made that way: true, the wavy shape is free of stress; false, it is a flat "
                   "sheet that starts a little off its place."},
          },
  };
}

}  // namespace

std::vector<Section> cloth_keys() { return {cloth(), place(), rotate(), waviness()}; }

}  // namespace sundrape

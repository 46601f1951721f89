#include "case_keys.hpp"

namespace sundrape::keys {

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

}  // namespace sundrape::keys

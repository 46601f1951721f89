#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

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

}  // namespace

std::vector<Section> load_keys() { return {load(), gust()}; }

}  // namespace sundrape

#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

Section top() {
  return {
      .name = "",
      .heading = "Top level",
      .doc =
          "Which case is run, and along which axes it is varied: every value of one axis with every value of the "
          "others.",
      .keys =
          {
              {.name = "title", .type = KeyType::text, .default_note = "the file's name", .doc = "A line for people."},
              {.name = "case", .type = KeyType::file, .required = true, .doc = "The case, relative to the study file."},
              {.name = "set",
               .type = KeyType::texts,
               .doc = "Settings `\"key.path=value\"` of all runs, as on the command line of `run`."},
              {.name = "axis",
               .type = KeyType::tables,
               .holds = "axis",
               .required = true,
               .doc = "What is varied; at least one."},
              {.name = "branches",
               .type = KeyType::table,
               .holds = "branches",
               .doc = "Which end states are one drape."},
          },
  };
}

Section axis() {
  return {
      .name = "axis",
      .heading = "`[[axis]]`",
      .doc = "One key of the case and the values that it takes.",
      .keys =
          {
              {.name = "key",
               .type = KeyType::text,
               .required = true,
               .doc = "As for `--set`: `\"cloth.waviness.seed\"`."},
              {.name = "values",
               .type = KeyType::values,
               .holds = "axis.values",
               .required = true,
               .doc = R"(A list, `[1, 2, 3]` or `["0.5 mm", "1 mm"]`, or a range.)"},
          },
  };
}

Section range() {
  return {
      .name = "axis.values",
      .heading = "`values = { ... }` of `[[axis]]`",
      .doc =
          "A range: `{ from = 1, to = 20 }`, `{ from = 0.1, to = 0.5, count = 5 }`, "
          "`{ from = 1e-3, to = 10, count = 5, spacing = \"log\", unit = \"gf*cm\" }`.",
      .keys =
          {
              {.name = "from", .required = true, .doc = "First value."},
              {.name = "to", .required = true, .doc = "Last value; with `step` the bound of the last."},
              {.name = "step",
               .range = positive(),
               .default_note = "1, unless `count` is given",
               .doc = "Between values."},
              {.name = "count",
               .type = KeyType::integer,
               .range = from_to(2, 100000),
               .default_note = "by `step`",
               .doc = "Number of values, both ends included; instead of `step`."},
              {.name = "spacing",
               .type = KeyType::choice,
               .choices = {"linear", "log"},
               .default_value = "\"linear\"",
               .doc = "Of `count` values: equal differences, or equal ratios."},
              {.name = "unit",
               .type = KeyType::text,
               .default_note = "none",
               .doc = "Unit of the values, e.g. `\"mm\"`."},
          },
  };
}

Section branches() {
  return {
      .name = "branches",
      .heading = "`[branches]`",
      .doc = "End states that differ little after a symmetry of the case are one drape.",
      .keys =
          {
              {.name = "same_shape",
               .range = above_to(0, 1),
               .default_value = "0.01",
               .doc = "RMS distance of the nodes over the diagonal of the cloth, below which two end states are one "
                      "drape."},
              {.name = "group_by",
               .type = KeyType::texts,
               .default_note =
                   "the axes that change the case itself: all but those of `cloth.waviness`, `cloth.start` and of the "
                   "tables of analyses",
               .doc = "Keys of axes: drapes are formed within each combination of their values."},
          },
  };
}

}  // namespace

std::vector<Section> study_keys() { return {top(), axis(), range(), branches()}; }

}  // namespace sundrape

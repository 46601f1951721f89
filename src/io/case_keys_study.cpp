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
              {.name = "output",
               .type = KeyType::tables,
               .holds = "output",
               .doc = "What is read off every run: the columns of the table."},
              {.name = "program",
               .type = KeyType::tables,
               .holds = "program",
               .doc = "Other programs that find numbers in the results."},
              {.name = "reference",
               .type = KeyType::table,
               .holds = "reference",
               .doc = "One more run, which outputs measure the distance from."},
              {.name = "figure",
               .type = KeyType::tables,
               .holds = "figure",
               .doc = "What `sundrape_postproc study` draws."},
              {.name = "resume",
               .type = KeyType::boolean,
               .default_value = "false",
               .doc = "Whether runs that were stopped go on from their checkpoints. A run that was resumed differs by "
                      "its tolerance from one that was not, so by default they begin anew, and tables do not hang on "
                      "what happened on the way."},
              {.name = "branches",
               .type = KeyType::table,
               .holds = "branches",
               .default_note = "drapes are sorted in studies without outputs",
               .doc = "Which end states are one drape."},
          },
  };
}

Section axis() {
  return {
      .name = "axis",
      .heading = "`[[axis]]`",
      .doc = "One key of the case and the values that it takes, or several keys that change together.",
      .keys =
          {
              {.name = "name",
               .type = KeyType::name,
               .default_note = "the key",
               .doc = "Of the table's column; required with `settings`."},
              {.name = "key", .type = KeyType::text, .doc = "As for `--set`: `\"cloth.waviness.seed\"`."},
              {.name = "values",
               .type = KeyType::values,
               .holds = "axis.values",
               .doc = R"(Of the key: a list, `[1, 2, 3]` or `["0.5 mm", "1 mm"]`, or a range.)"},
              {.name = "settings",
               .type = KeyType::text_lists,
               .doc = R"(Instead of `key` and `values`: each value as a list of settings, )"
                      R"(`[["model=particle", "cloth.cells=[20, 20]"], ["model=shell", "cloth.cells=[10, 10]"]]`.)"},
              {.name = "labels",
               .type = KeyType::texts,
               .default_note = "the values, or numbers from 1 on",
               .doc = "What tables and figures call each value."},
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

Section output() {
  return {
      .name = "output",
      .heading = "`[[output]]`",
      .doc = "A number that is read off every run when it is done.",
      .keys =
          {
              {.name = "name", .type = KeyType::name, .required = true, .doc = "Of the table's column."},
              {.name = "value",
               .type = KeyType::text,
               .required = true,
               .doc = "An expression over what the result holds: `\"at(probe.tip.z, 0.3 s)\"`."},
              {.name = "unit",
               .type = KeyType::text,
               .default_note = "SI",
               .doc = "Unit of the column, such as `\"cm\"`. An expression's value is SI, and is divided by it."},
          },
  };
}

Section program() {
  return {
      .name = "program",
      .heading = "`[[program]]`",
      .doc =
          "A program that is called on the result of every run and writes a report in JSON, whose numbers outputs may "
          "use.",
      .keys =
          {
              {.name = "command",
               .type = KeyType::texts,
               .required = true,
               .doc = "Its words; `{result}` stands for the result's file, `{json}` for that of the report."},
              {.name = "numbers",
               .type = KeyType::texts,
               .required = true,
               .doc =
                   "`\"name=/place/in/the/report\"` each: a JSON pointer (RFC 6901), such as `/drapes/0/coefficient`."},
          },
  };
}

Section reference() {
  return {
      .name = "reference",
      .heading = "`[reference]`",
      .doc =
          "A run with settings of its own instead of the axes' values, such as tighter tolerances. Outputs may ask for "
          "`reference.rms` and `reference.max`; meshes must be the same.",
      .keys =
          {
              {.name = "set",
               .type = KeyType::texts,
               .required = true,
               .doc = "Its settings, on top of those of all runs."},
          },
  };
}

Section figure() {
  const auto log = [](const char* name) {
    return Key{.name = name, .type = KeyType::boolean, .default_value = "false", .doc = "A logarithmic scale."};
  };
  return {
      .name = "figure",
      .heading = "`[[figure]]`",
      .doc = "Curves of outputs.",
      .keys =
          {
              {.name = "name", .type = KeyType::name, .required = true, .doc = "Of its file."},
              {.name = "x", .type = KeyType::text, .required = true, .doc = "An axis or an output, by name."},
              {.name = "y", .type = KeyType::texts, .required = true, .doc = "Outputs, by name: a row of panels each."},
              {.name = "by", .type = KeyType::text, .doc = "The axis whose values make a curve each."},
              {.name = "curves",
               .type = KeyType::texts,
               .default_note = "all",
               .doc = "Labels of the values of `by` that are drawn, in this order."},
              {.name = "panels", .type = KeyType::text, .doc = "The axis whose values make a column of panels each."},
              log("log_x"),
              log("log_y"),
              {.name = "slope",
               .doc = "Of a straight line for the eye where both scales are logarithmic: an order of convergence."},
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
               .doc = "Names of axes: drapes are formed within each combination of their values."},
          },
  };
}

}  // namespace

std::vector<Section> study_keys() {
  return {top(), axis(), range(), output(), program(), reference(), figure(), branches()};
}

}  // namespace sundrape

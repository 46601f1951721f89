#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

Section top() {
  return {
      .name = "",
      .heading = "Top level",
      .doc = "Which numbers of which case are sought, and what was measured.",
      .keys =
          {
              {.name = "title", .type = KeyType::text, .default_note = "the file's name", .doc = "A line for people."},
              {.name = "case", .type = KeyType::file, .required = true, .doc = "The case, relative to the fit file."},
              {.name = "set",
               .type = KeyType::texts,
               .doc = "Settings `\"key.path=value\"` of all runs, as on the command line of `run`."},
              {.name = "parameter",
               .type = KeyType::tables,
               .holds = "parameter",
               .required = true,
               .doc = "What is sought; at least one."},
              {.name = "measured",
               .type = KeyType::tables,
               .holds = "measured",
               .required = true,
               .doc = "What was measured; at least one."},
              {.name = "max_iterations",
               .type = KeyType::integer,
               .range = from_to(1, 1000),
               .default_value = "30",
               .doc = "Runs of the case after which the search is given up."},
              {.name = "tolerance",
               .range = above_to(0, 0.1),
               .default_value = "0.01",
               .doc = "The search ends once a step would change every parameter by less than this part of its standard "
                      "error."},
              {.name = "confidence",
               .range = {.low = 0, .high = 1},
               .default_value = "0.95",
               .doc = "Probability with which intervals hold the true values, errors being as assumed."},
          },
  };
}

Section parameter() {
  const auto quantity = [](std::string name, std::string note, std::string doc) {
    return Key{
        .name = std::move(name), .type = KeyType::quantity, .default_note = std::move(note), .doc = std::move(doc)};
  };
  return {
      .name = "parameter",
      .heading = "`[[parameter]]`",
      .doc = "A continuous number of the case.",
      .keys =
          {
              {.name = "key",
               .type = KeyType::text,
               .required = true,
               .doc = "As for `--set`: `\"material.bending.rigidity\"`, `\"material.bending.coefficients.0\"`."},
              quantity("start", "the case's own value", "Where the search begins, in the key's unit."),
              quantity("lower", "that of the key's range", "Least value."),
              quantity("upper", "that of the key's range", "Largest value."),
              {.name = "scale",
               .type = KeyType::choice,
               .choices = {"auto", "log", "linear"},
               .default_value = "\"auto\"",
               .doc =
                   "Whether the search and the interval are in the parameter's logarithm or in the parameter itself; "
                   "`auto`: the logarithm where values must be positive."},
          },
  };
}

Key coordinate(std::string name) {
  return {.name = std::move(name),
          .unit = "m",
          .default_note = "not measured",
          .kinds = {"probe"},
          .doc = "Where it was seen."};
}

Section measured() {
  return {
      .name = "measured",
      .heading = "`[[measured]]`",
      .kind_key = "kind",
      .doc = "Points of a curve of the cloth, points of its outline, the place of a probe, or the height of the cloth.",
      .keys =
          {
              {.name = "kind",
               .type = KeyType::choice,
               .choices = {"curve", "outline", "probe", "height"},
               .required = true,
               .doc = "`curve`: points on a line of nodes, seen in a plane. `outline`: points on the cloth's boundary, "
                      "seen from above. `probe`: coordinates of one probe of the case. `height`: the highest node."},
              {.name = "time",
               .unit = "s",
               .default_note = "the end of the run",
               .doc = "When; one of the times of the run's frames."},
              {.name = "sd",
               .unit = "m",
               .range = positive(),
               .required = true,
               .doc = "Standard deviation of every number measured."},
              only_for({"curve"}, nodes()),
              {.name = "plane",
               .type = KeyType::choice,
               .choices = {"xy", "xz", "yz"},
               .default_value = "\"xz\"",
               .kinds = {"curve"},
               .doc = "That the points are in."},
              {.name = "file",
               .type = KeyType::file,
               .required = true,
               .kinds = {"curve", "outline"},
               .doc = "A table (CSV) beside the fit file: two coordinates a line, and a standard deviation if there is "
                      "a third column; lines that do not begin with a number are skipped."},
              {.name = "unit",
               .type = KeyType::unit,
               .unit = "m",
               .default_value = "\"m\"",
               .kinds = {"curve", "outline"},
               .doc = "Of the table's numbers."},
              {.name = "name", .type = KeyType::text, .required = true, .kinds = {"probe"}, .doc = "The probe's."},
              coordinate("x"),
              coordinate("y"),
              coordinate("z"),
              {.name = "value", .unit = "m", .required = true, .kinds = {"height"}, .doc = "z of the highest node."},
          },
  };
}

}  // namespace

std::vector<Section> fit_keys() {
  std::vector<Section> all{top(), parameter(), measured()};
  for (auto& section : support_keys())
    if (section.name.starts_with("selector")) all.push_back(std::move(section));
  return all;
}

}  // namespace sundrape

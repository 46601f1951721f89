#include "case_keys.hpp"

namespace sundrape {

std::vector<Section> top_keys() {
  return {{
      .name = "",
      .heading = "Top level",
      .doc = "What the case is, and the tables that describe it.",
      .keys =
          {
              {.name = "title", .type = KeyType::text, .default_note = "the file's name", .doc = "A line for people."},
              {.name = "model",
               .type = KeyType::choice,
               .choices = {"particle", "shell"},
               .default_value = "\"particle\"",
               .doc =
                   "How the sheet is discretised: a net of particles and springs, or finite elements of a shell with "
                   "a director at every node."},
              {.name = "analysis",
               .type = KeyType::choice,
               .choices = {"dynamics", "relaxation", "arc-length"},
               .required = true,
               .doc =
                   "What to compute: a motion in time, a static equilibrium, or the path of equilibria that loads and "
                   "moved supports lead along. Tables of other analyses may stay in "
                   "the file; they are checked, not used."},
              {.name = "cloth",
               .type = KeyType::pieces,
               .holds = "cloth",
               .required = true,
               .doc = "The sheet; `[[cloth]]` with a `name` each where there are several."},
              {.name = "material",
               .type = KeyType::table,
               .holds = "material",
               .doc = "Its fabric; of several sheets the one of those that name none of their own."},
              {.name = "shell",
               .type = KeyType::table,
               .holds = "shell",
               .doc = "Its elements, of `model = \"shell\"`."},
              {.name = "fix", .type = KeyType::tables, .holds = "fix", .doc = "Supports."},
              {.name = "motion", .type = KeyType::tables, .holds = "motion", .doc = "Prescribed paths of node sets."},
              {.name = "load", .type = KeyType::tables, .holds = "load", .doc = "What pulls and pushes."},
              {.name = "obstacle", .type = KeyType::tables, .holds = "obstacle", .doc = "Rigid bodies in the way."},
              {.name = "contact", .type = KeyType::table, .holds = "contact", .doc = "How cloth meets obstacles."},
              {.name = "dynamics", .type = KeyType::table, .holds = "dynamics", .doc = "Integration in time."},
              {.name = "relaxation", .type = KeyType::table, .holds = "relaxation", .doc = "Search for equilibrium."},
              {.name = "arc-length", .type = KeyType::table, .holds = "arc-length", .doc = "Equilibrium paths."},
              {.name = "sensitivity",
               .type = KeyType::table,
               .holds = "sensitivity",
               .doc = "Derivatives of what the run computes with respect to numbers of the case."},
              {.name = "output", .type = KeyType::table, .holds = "output", .doc = "What the result file keeps."},
          },
  }};
}

}  // namespace sundrape

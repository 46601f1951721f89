#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

Key linear_solver() {
  return {.name = "linear_solver",
          .type = KeyType::choice,
          .choices = {"auto", "cg", "cholesky", "lu"},
          .default_value = "\"auto\"",
          .doc = "Of the condensed system."};
}

Key time_limit() {
  return {.name = "time_limit",
          .unit = "s",
          .range = positive(),
          .default_note = "none",
          .doc = "Wall-clock time after which the run stops, with what it has."};
}

Key tolerance() {
  return {.name = "tolerance",
          .range = above_to(0, 0.1),
          .default_value = "1e-6",
          .doc = "On the out-of-balance force over the external force."};
}

Section dynamics() {
  return {
      .name = "dynamics",
      .heading = "`[dynamics]`",
      .keys =
          {
              {.name = "integrator",
               .type = KeyType::choice,
               .choices = {"cvode", "ida", "rk4"},
               .default_value = "\"cvode\"",
               .doc = "BDF on the rates or on the residual, or explicit Runge–Kutta with a fixed step."},
              {.name = "duration",
               .unit = "s",
               .range = positive(),
               .default_note = "required by `analysis = \"dynamics\"`",
               .doc = "Simulated time."},
              {.name = "rtol",
               .range = above_to(0, 0.1),
               .default_value = "1e-4",
               .doc = "Relative tolerance of a step."},
              {.name = "atol_position",
               .unit = "m",
               .range = positive(),
               .default_note = "0.25 `rtol` L",
               .doc = "Absolute tolerance of positions; L: the sheet's longest side."},
              {.name = "atol_velocity",
               .unit = "m/s",
               .range = positive(),
               .default_note = "min(0.01, 100 `rtol`) √(g L)",
               .doc = "Absolute tolerance of velocities."},
              {.name = "max_order",
               .type = KeyType::integer,
               .range = from_to(1, 5),
               .default_value = "2",
               .doc = "Highest order of the BDF."},
              {.name = "step",
               .unit = "s",
               .range = positive(),
               .default_note = "0.8 of the stability limit",
               .doc = "The fixed step of `integrator = \"rk4\"`; the others choose their own."},
              {.name = "max_step", .unit = "s", .range = positive(), .default_note = "none", .doc = "Longest step."},
              {.name = "first_step",
               .unit = "s",
               .range = positive(),
               .default_note = "chosen by the integrator",
               .doc = "Step to start with."},
              {.name = "until_rest",
               .range = above_to(0, 0.1),
               .default_note = "the whole duration",
               .doc = "Ends the motion once the cloth rests: its kinetic energy has stayed below this part of weight × "
                      "L for "
                      "the time 2π√(L/g), and the out-of-balance force is below 0.01 of the external one."},
              linear_solver(),
              time_limit(),
          },
  };
}

Section relaxation() {
  return {
      .name = "relaxation",
      .heading = "`[relaxation]`",
      .keys =
          {
              tolerance(),
              {.name = "scheme",
               .type = KeyType::choice,
               .choices = {"implicit", "chapter"},
               .default_value = "\"implicit\"",
               .doc = "Damped implicit steps that end as Newton's, or the explicit baseline of the literature."},
              {.name = "max_iterations",
               .type = KeyType::integer,
               .range = from_to(1, 1e9),
               .default_note = "2000; 1,000,000 of the chapter's",
               .doc = "Then it stops with a diagnosis."},
              {.name = "first_step",
               .unit = "s",
               .range = positive(),
               .default_note = "from the size and gravity",
               .doc = "Step to start with."},
              {.name = "growth",
               .range = above_to(1, 10),
               .default_value = "1.5",
               .doc = "Factor of successive steps."},
              linear_solver(),
              {.name = "c_disp",
               .unit = "m/N",
               .range = positive(),
               .default_note = "from the stiffest mode",
               .doc = "Displacement per force of `scheme = \"chapter\"`."},
              {.name = "c_acc",
               .unit = "N/m",
               .range = positive(),
               .default_note = "from the stiffest mode",
               .doc = "Acceleration constant of `scheme = \"chapter\"`."},
              time_limit(),
          },
  };
}

Section arc_length() {
  return {
      .name = "arc-length",
      .heading = "`[\"arc-length\"]`",
      .doc = "Checked, but not used in this version.",
      .keys =
          {
              tolerance(),
              {.name = "target_iterations",
               .type = KeyType::integer,
               .range = from_to(1, 100),
               .default_value = "7",
               .doc = "Newton iterations a step that the step size aims at."},
              {.name = "first_load_increment",
               .range = positive(),
               .default_value = "2.5e-4",
               .doc = "Of the load factor, in the first step."},
          },
  };
}

Section output() {
  return {
      .name = "output",
      .heading = "`[output]`",
      .doc = "`frames` or `every`, not both. The start and the end are always kept.",
      .keys =
          {
              {.name = "frames",
               .type = KeyType::integer,
               .range = from_to(1, 1e6),
               .default_value = "60",
               .doc = "Equal intervals that the duration is cut into."},
              {.name = "every",
               .unit = "s",
               .range = positive(),
               .default_note = "by `frames`",
               .doc = "Time between frames."},
              {.name = "checkpoint_every",
               .unit = "s",
               .range = positive(),
               .default_value = "\"2 s\"",
               .doc = "Wall-clock time between checkpoints of a motion: what a kill can cost."},
              {.name = "resultants",
               .type = KeyType::boolean,
               .default_value = "true",
               .doc = "Strains and stress resultants of a shell's elements in every frame."},
              {.name = "probes",
               .type = KeyType::tables,
               .holds = "output.probes",
               .doc = "Nodes that are recorded at every accepted step."},
          },
  };
}

Section probes() {
  auto near = vector3("near", "m", "The node closest to this point of the initial sheet.");
  near.required = true;
  return {
      .name = "output.probes",
      .heading = "`probes = [ { ... } ]` of `[output]`",
      .keys = {{.name = "name", .type = KeyType::name, .required = true, .doc = "In the result; no two alike."}, near}};
}

}  // namespace

std::vector<Section> analysis_keys() { return {dynamics(), relaxation(), arc_length(), output(), probes()}; }

}  // namespace sundrape

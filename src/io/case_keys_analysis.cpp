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

Key unstable_end() {
  return {.name = "unstable_end",
          .type = KeyType::choice,
          .choices = {"keep", "relax"},
          .default_value = "\"keep\"",
          .doc =
              "An unstable equilibrium at the end is reported as it is, or pushed along its unstable mode and relaxed "
              "to the stable one next to it."};
}

Section dynamics() {
  return {
      .name = "dynamics",
      .heading = "`[dynamics]`",
      .keys =
          {
              {.name = "integrator",
               .type = KeyType::choice,
               .choices = {"cvode", "ida", "rk4", "dirk"},
               .default_value = "\"cvode\"",
               .doc = "BDF on the rates or on the residual, explicit Runge–Kutta with a fixed step, or diagonally "
                      "implicit "
                      "Runge–Kutta."},
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
               .doc = "Highest order of the BDF; the order of `\"dirk\"`, 2 to 5."},
              {.name = "step",
               .unit = "s",
               .range = positive(),
               .default_note = "`\"rk4\"`: 0.8 of the stability limit; `\"dirk\"`: chosen by its error test",
               .doc = "A fixed step, of `\"rk4\"` and `\"dirk\"`; the others choose their own."},
              {.name = "max_step", .unit = "s", .range = positive(), .default_note = "none", .doc = "Longest step."},
              {.name = "first_step",
               .unit = "s",
               .range = positive(),
               .default_note = "chosen by the integrator",
               .doc = "Step to start with."},
              {.name = "until_rest",
               .range = above_to(0, 0.1),
               .default_note = "the whole duration",
               .doc =
                   "Ends the motion once the cloth rests: its kinetic energy has stayed below this part of weight × "
                   "L for the time 2π√(L/g), loads have their full size, the out-of-balance force is below 0.01 of the "
                   "external one, and the equilibrium is stable."},
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
              {.name = "continuation",
               .type = KeyType::choice,
               .choices = {"auto", "off"},
               .default_value = "\"auto\"",
               .doc = "Start from the equilibrium on coarser meshes of the same cloth, where there are any; `\"off\"`: "
                      "from "
                      "the placed sheet."},
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
              unstable_end(),
              {.name = "times",
               .type = KeyType::series,
               .unit = "s",
               .entries = 10000,
               .range = not_negative(),
               .default_note = "twenty from 0 to the end of the last path",
               .doc =
                   "Where supports or obstacles move: when to look for equilibrium, each from the one before. Each is "
                   "a frame."},
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
      .doc = "Equilibrium paths by Newton's method, in the stages that `stages` of loads and motions describe.",
      .keys =
          {
              tolerance(),
              {.name = "control",
               .type = KeyType::choice,
               .choices = {"arc-length", "load"},
               .default_value = "\"arc-length\"",
               .doc = "What a step holds: its length along the path, which passes limit points, or the load, with a "
                      "line search."},
              {.name = "target_iterations",
               .type = KeyType::integer,
               .range = from_to(1, 100),
               .default_value = "7",
               .doc = "Newton iterations a step that the step size aims at."},
              {.name = "first_load_increment",
               .type = KeyType::series,
               .entries = 20,
               .range = above_to(0, 1),
               .default_value = "2.5e-4",
               .doc = "Of the load factor, in the first step of each stage; the last one goes for later stages."},
              {.name = "acceleration",
               .type = KeyType::boolean,
               .default_value = "true",
               .doc = "Steps grow and shrink by target over actual iterations; false: they stay as long as the first."},
              {.name = "max_iterations",
               .type = KeyType::integer,
               .range = from_to(2, 1000),
               .default_value = "30",
               .doc = "In one step; then it is halved."},
              {.name = "max_steps",
               .type = KeyType::integer,
               .range = from_to(1, 1e7),
               .default_value = "1000",
               .doc = "Then it stops with a diagnosis."},
              {.name = "largest_move",
               .unit = "m",
               .range = positive(),
               .default_note = "L/10, L the sheet's longest side",
               .doc = "Of a node in the prediction of a step, but for a stage's first."},
              {.name = "when_unstable",
               .type = KeyType::choice,
               .choices = {"follow", "fall"},
               .default_value = "\"follow\"",
               .doc = "Beyond a critical point: follow the unstable path, or fall to the next stable equilibrium under "
                      "the same load, as cloth does, and go on from there."},
              {.name = "at_bifurcation",
               .type = KeyType::choice,
               .choices = {"pass", "switch", "stop"},
               .default_value = "\"pass\"",
               .doc = "Where the path forks: report it and go on, leave along the critical mode, or end there."},
              {.name = "branch",
               .type = KeyType::integer,
               .range = from_to(1, 1000),
               .default_value = "1",
               .doc = "At which fork to switch or stop."},
              {.name = "branch_amplitude",
               .unit = "m",
               .default_note = "L/100",
               .doc = "First move along the critical mode; a negative one leaves to the other side."},
              unstable_end(),
              {.name = "frame_every",
               .type = KeyType::integer,
               .range = from_to(1, 1e6),
               .default_value = "1",
               .doc = "Steps between frames."},
              time_limit(),
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

Section sensitivity() {
  return {
      .name = "sensitivity",
      .heading = "`[sensitivity]`",
      .doc = "See [sensitivities.md](sensitivities.md).",
      .keys = {{.name = "parameters",
                .type = KeyType::texts,
                .doc = "Keys of the case, as for `--set`, whose values are continuous numbers: "
                       "`[\"material.bending.rigidity\", \"obstacle.0.friction\"]`. The result gets the derivatives of "
                       "all positions, and in dynamics of velocities."}},
  };
}

}  // namespace

std::vector<Section> analysis_keys() {
  return {dynamics(), relaxation(), arc_length(), sensitivity(), output(), probes()};
}

}  // namespace sundrape

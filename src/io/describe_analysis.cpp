#include <fmt/format.h>

#include "case_choices.hpp"
#include "describe_parts.hpp"

namespace sundrape {

void describe_dynamics(CaseDescription& out, const DynamicsCase& dynamics) {
  out.enter("dynamics", "dynamics");
  out.text("integrator", choices::integrator.name(dynamics.integrator));
  out.number("duration", dynamics.duration);
  out.number("rtol", dynamics.rtol);
  out.maybe_number("atol_position", dynamics.atol_position);
  out.maybe_number("atol_velocity", dynamics.atol_velocity);
  out.verbatim("max_order", fmt::format("{}", dynamics.max_order));
  if (dynamics.integrator == IntegratorKind::rk4 || dynamics.integrator == IntegratorKind::dirk)
    out.maybe_number("step", dynamics.step);
  out.maybe_number("max_step", dynamics.max_step);
  out.maybe_number("first_step", dynamics.first_step);
  out.text("linear_solver", dynamics.linear_solver);
  out.maybe_number("until_rest", dynamics.until_rest);
  out.maybe_number("time_limit", dynamics.time_limit);
}

void describe_relaxation(CaseDescription& out, const RelaxationCase& relaxation) {
  out.enter("relaxation", "relaxation");
  out.number("tolerance", relaxation.tolerance);
  out.text("scheme", relaxation.scheme);
  out.text("continuation", relaxation.continuation ? "auto" : "off");
  if (relaxation.max_iterations) out.verbatim("max_iterations", fmt::format("{}", *relaxation.max_iterations));
  out.maybe_number("first_step", relaxation.first_step);
  out.number("growth", relaxation.growth);
  out.text("linear_solver", relaxation.linear_solver);
  out.text("unstable_end", relaxation.relax_unstable ? "relax" : "keep");
  if (!relaxation.times.empty()) out.numbers("times", relaxation.times);
  if (relaxation.scheme == "chapter") {
    out.maybe_number("c_disp", relaxation.c_disp);
    out.maybe_number("c_acc", relaxation.c_acc);
  }
  out.maybe_number("time_limit", relaxation.time_limit);
}

void describe_arc_length(CaseDescription& out, const ArcLengthCase& path, int stages) {
  out.enter("arc-length", "arc-length");
  out.derived("stages", stages, "1");
  out.number("tolerance", path.tolerance);
  out.text("control", choices::path_control.name(path.control));
  out.verbatim("target_iterations", fmt::format("{}", path.target_iterations));
  out.numbers("first_load_increment", path.first_increment);
  out.verbatim("acceleration", path.acceleration ? "true" : "false");
  out.verbatim("max_iterations", fmt::format("{}", path.max_iterations));
  out.verbatim("max_steps", fmt::format("{}", path.max_steps));
  out.maybe_number("largest_move", path.largest_move);
  out.text("when_unstable", path.fall ? "fall" : "follow");
  out.text("at_bifurcation", choices::at_bifurcation.name(path.at_bifurcation));
  if (path.at_bifurcation != BifurcationKind::pass) {
    out.verbatim("branch", fmt::format("{}", path.branch));
    out.maybe_number("branch_amplitude", path.branch_amplitude);
  }
  out.text("unstable_end", path.relax_unstable ? "relax" : "keep");
  out.verbatim("frame_every", fmt::format("{}", path.frame_every));
  out.maybe_number("time_limit", path.time_limit);
}

void describe_output(CaseDescription& out, const OutputCase& output, Model model) {
  out.heading("output");
  out.enter("output", "output");
  if (!output.frame_times.empty())
    out.verbatim("frames",
                 fmt::format("{} ({} with the one at 0 s)", output.frame_times.size() - 1, output.frame_times.size()));
  out.number("checkpoint_every", output.checkpoint_every);
  if (model == Model::shell) out.verbatim("resultants", output.resultants ? "true" : "false");
  for (std::size_t i = 0; i < output.probes.size(); ++i) {
    out.enter("output.probes", fmt::format("output.probes.{}", i));
    out.text("name", output.probes[i].name);
    out.vector3("near", output.probes[i].near);
  }
}

}  // namespace sundrape

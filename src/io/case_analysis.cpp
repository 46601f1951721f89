#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "case_choices.hpp"
#include "case_parts.hpp"

namespace sundrape {
namespace {

constexpr double most_frames = 1e6;

std::vector<double> resolve_frame_times(const CaseSection& output, double duration) {
  std::vector<double> times{0};
  if (const auto every = output.maybe_number("every")) {
    if (duration / *every > most_frames)
      output.fail("every", fmt::format("{:.10g} s makes more than {} frames", *every, most_frames));
    // The last multiple and the duration are one frame where only round-off keeps them apart.
    for (int i = 1; i * *every < duration * (1 - 1e-9); ++i) times.push_back(i * *every);
  } else {
    const int frames = output.integer("frames");
    for (int i = 1; i < frames; ++i) times.push_back(duration * i / frames);
  }
  times.push_back(duration);
  return times;
}

}  // namespace

std::string to_string(Analysis analysis) { return choices::analysis.name(analysis); }

DynamicsCase resolve_dynamics(const CaseSection& section) {
  DynamicsCase dynamics;
  const std::string integrator = section.text("integrator");
  dynamics.integrator = choices::integrator.value(integrator);
  dynamics.duration = section.maybe_number("duration").value_or(0);
  dynamics.rtol = section.number("rtol");
  dynamics.atol_position = section.maybe_number("atol_position");
  dynamics.atol_velocity = section.maybe_number("atol_velocity");
  dynamics.max_order = section.integer("max_order");
  dynamics.step = section.maybe_number("step");
  const bool is_dirk = dynamics.integrator == IntegratorKind::dirk;
  if (is_dirk && dynamics.max_order < 2)
    section.fail("max_order",
                 fmt::format("{} is outside [2, 5], the orders of integrator = \"dirk\"", dynamics.max_order));
  if (dynamics.step && dynamics.integrator != IntegratorKind::rk4 && !is_dirk)
    section.fail("step", fmt::format("integrator = \"{}\" chooses its steps itself; max_step bounds them", integrator));
  dynamics.max_step = section.maybe_number("max_step");
  dynamics.first_step = section.maybe_number("first_step");
  dynamics.linear_solver = section.text("linear_solver");
  dynamics.time_limit = section.maybe_number("time_limit");
  dynamics.until_rest = section.maybe_number("until_rest");
  return dynamics;
}

RelaxationCase resolve_relaxation(const CaseSection& section) {
  RelaxationCase relaxation;
  relaxation.tolerance = section.number("tolerance");
  relaxation.scheme = section.text("scheme");
  relaxation.continuation = section.text("continuation") == "auto";
  if (const auto most = section.maybe_number("max_iterations")) relaxation.max_iterations = static_cast<int>(*most);
  relaxation.first_step = section.maybe_number("first_step");
  relaxation.growth = section.number("growth");
  relaxation.linear_solver = section.text("linear_solver");
  relaxation.relax_unstable = section.text("unstable_end") == "relax";
  relaxation.c_disp = section.maybe_number("c_disp");
  relaxation.c_acc = section.maybe_number("c_acc");
  if (section.has("times")) relaxation.times = section.series("times");
  if (std::ranges::adjacent_find(relaxation.times, std::greater_equal<>()) != relaxation.times.end())
    section.fail("times", "do not ascend");
  relaxation.time_limit = section.maybe_number("time_limit");
  return relaxation;
}

ArcLengthCase resolve_arc_length(const CaseSection& section) {
  ArcLengthCase path;
  path.tolerance = section.number("tolerance");
  path.control = choices::path_control.value(section.text("control"));
  path.target_iterations = section.integer("target_iterations");
  path.first_increment = section.series("first_load_increment");
  path.acceleration = section.boolean("acceleration");
  path.max_iterations = section.integer("max_iterations");
  path.max_steps = section.integer("max_steps");
  path.largest_move = section.maybe_number("largest_move");
  path.fall = section.text("when_unstable") == "fall";
  path.at_bifurcation = choices::at_bifurcation.value(section.text("at_bifurcation"));
  path.branch = section.integer("branch");
  path.branch_amplitude = section.maybe_number("branch_amplitude");
  if (path.branch_amplitude == 0.0)
    section.fail("branch_amplitude", "0 does not leave the path; accepted: positive or negative lengths");
  path.relax_unstable = section.text("unstable_end") == "relax";
  path.frame_every = section.integer("frame_every");
  path.time_limit = section.maybe_number("time_limit");
  return path;
}

OutputCase resolve_output(const CaseSection& section, double duration) {
  if (section.has("frames") && section.has("every"))
    section.fail("every", "frames says it already: give either, not both");
  OutputCase output;
  output.checkpoint_every = section.number("checkpoint_every");
  output.resultants = section.boolean("resultants");
  if (duration > 0) output.frame_times = resolve_frame_times(section, duration);
  for (const auto& entry : section.tables("probes")) {
    ProbeCase probe{entry.text("name"), entry.vector3("near"), entry.source("near")};
    for (const auto& earlier : output.probes)
      if (earlier.name == probe.name) entry.fail("name", fmt::format("'{}' is the name of two probes", probe.name));
    output.probes.push_back(std::move(probe));
  }
  return output;
}

}  // namespace sundrape

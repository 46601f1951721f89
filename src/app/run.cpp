#include "sundrape/app/run.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <omp.h>

#include "sundrape/app/analyses.hpp"
#include "sundrape/app/interrupt.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/io/file_error.hpp"
#include "sundrape/io/file_lock.hpp"

#include "write_text.hpp"

namespace sundrape {
namespace {

std::filesystem::path output_path(const RunOptions& options) {
  if (options.output) return *options.output;
  if (options.resume) return *options.resume;
  return options.case_file.stem().string() + ".h5";
}

void require_folder(const std::filesystem::path& file) {
  const auto folder = file.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw FileError(fmt::format("{}: its folder does not exist", file.string()));
}

/// Before the work rather than after it.
void require_room(const RunOptions& options, const std::filesystem::path& output) {
  for (const auto& file : {output, options.summary.value_or(output)})
    if (std::filesystem::exists(file) && std::filesystem::equivalent(file, options.case_file))
      throw FileError(
          fmt::format("{}: is the case itself; choose another name for what the run writes", file.string()));
  const bool goes_on = options.resume && std::filesystem::exists(*options.resume) && std::filesystem::exists(output) &&
                       std::filesystem::equivalent(*options.resume, output);
  if (std::filesystem::exists(output) && !options.overwrite && !goes_on)
    throw FileError(
        fmt::format("{}: exists already; choose another -o, or overwrite it with --force", output.string()));
  if (options.summary) require_folder(*options.summary);
}

/// What a user should know about the numbers before using them.
void report_extremes(const Case& c, Recorder& recorder) {
  const auto& e = recorder.extremes();
  const bool dynamics = c.analysis == Analysis::dynamics;
  const std::string when = dynamics ? "at any time" : "at the end", of_frames = dynamics ? "over the frames" : when;
  recorder.statistic("largest_edge_strain", e.largest_edge_strain, "of a thread segment, " + of_frames);
  recorder.statistic("smallest_edge_strain", e.smallest_edge_strain, "of a thread segment, " + of_frames);
  recorder.statistic("deepest_penetration_m", e.deepest_penetration,
                     "of a contact point into an obstacle, or of cloth into cloth, " + when);
  recorder.statistic("sharpest_bend_deg", e.sharpest_bend * 180 / std::numbers::pi,
                     "turn of a thread from one edge to the next, or of a director along an edge, " + of_frames);
  if (e.deepest_penetration > c.contact.penetration)
    recorder.warn(fmt::format(
        "the cloth sank {:.3g} mm into what it touches, more than the {:.3g} mm allowed: raise contact.stiffness",
        1e3 * e.deepest_penetration, 1e3 * c.contact.penetration));
  if (const auto first = recorder.first_crossing())
    recorder.warn(fmt::format("the cloth passes through itself, first in the frame at {} {:.4g} (/frames/crossings){}",
                              c.analysis == Analysis::arc_length ? "load factor" : "t =", *first,
                              c.contact.self ? "" : ": contact.self = true keeps layers apart"));
  const bool shell = c.model == Model::shell;
  if (shell)
    recorder.statistic("largest_membrane_strain", e.largest_membrane_strain,
                       "principal strain at the centre of an element, " + of_frames);
  const double stretch = shell ? e.largest_membrane_strain : e.largest_edge_strain;
  if (stretch > 0.05)
    recorder.warn(
        fmt::format("threads stretched by up to {:.1f} %: the fabric's modulus may be too small, or a load too large",
                    100 * stretch));
  if (e.sharpest_bend > 150 * std::numbers::pi / 180)
    recorder.warn(
        fmt::format("a thread folds by {:.0f}° from one edge to the next: the mesh is too coarse for this fold",
                    e.sharpest_bend * 180 / std::numbers::pi));
}

std::string report(const nlohmann::json& s, const std::filesystem::path& output) {
  const auto& final = s.at("final");
  std::string text =
      fmt::format("{}: {} frames in {}", s.at("status").get<std::string>(), s.at("frames").get<int>(), output.string());
  text += fmt::format("\n  wall {:.2f} s, CPU {:.2f} s", s.at("wall_seconds").get<double>(),
                      s.at("cpu_seconds").get<double>());
  if (s.contains("steps"))
    text += fmt::format("; {} steps, {} Newton iterations, {} refused, method dissipated {:.3g} J",
                        s.at("steps").get<long>(), s.at("newton_iterations").get<long>(),
                        s.at("error_test_failures").get<long>() + s.at("step_solve_failures").get<long>(),
                        final.at("energy_J").at("method_dissipated").get<double>());
  if (s.contains("path_steps"))
    text += fmt::format("; {} steps, {} Newton iterations, {} critical points, residual {:.2e}, {} negative pivots",
                        s.at("path_steps").get<long>(), s.at("newton_iterations").get<long>(),
                        s.at("critical_points").get<long>(), final.at("residual").get<double>(),
                        final.at("negative_pivots").get<int>());
  if (s.contains("iterations"))
    text += fmt::format("; {} iterations, residual {:.2e}, {} negative pivots", s.at("iterations").get<long>(),
                        final.at("residual").get<double>(), final.at("negative_pivots").get<int>());
  text +=
      fmt::format("\n  largest edge strain {:.3g} %, deepest penetration {:.3g} mm",
                  100 * s.at("largest_edge_strain").get<double>(), 1e3 * s.at("deepest_penetration_m").get<double>());
  for (const auto& warning : s.at("warnings")) text += "\n  warning: " + warning.get<std::string>();
  return text;
}

std::vector<StepColumn> step_columns(Analysis analysis) {
  if (analysis == Analysis::dynamics) return dynamics_step_columns();
  return analysis == Analysis::relaxation ? relaxation_step_columns() : path_step_columns();
}

AnalysisEnd run_analysis(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress) {
  switch (c.analysis) {
    case Analysis::dynamics:
      return run_dynamics(c, model, recorder, progress);
    case Analysis::relaxation:
      return c.moves() ? run_quasi_static(c, model, recorder, progress) : run_relaxation(c, model, recorder, progress);
    case Analysis::arc_length:
      break;
  }
  return run_arc_length(c, model, recorder, progress);
}

/// What the grid of a mesh obstacle cannot show is not there for the cloth.
void warn_of_rounding(const CaseModel& model, Recorder& recorder) {
  for (const auto& obstacle : model.obstacles) {
    if (obstacle.kind != "mesh") continue;
    const double voxel = obstacle.parameters.at("voxel").front(), rounding = obstacle.parameters.at("rounding").front();
    if (rounding <= voxel) continue;
    const auto loss =
        std::isfinite(rounding) ? fmt::format("cuts back by up to {:.3g} mm", 1e3 * rounding) : "cuts off";
    recorder.warn(fmt::format("obstacle '{}' has thin parts that its grid of {:.3g} mm {}: give it a smaller `voxel`",
                              obstacle.name, 1e3 * voxel, loss));
  }
}

}  // namespace

ExitStatus run_case(const RunOptions& options) {
  const RunClock clock;
  omp_set_num_threads(options.threads);
  const Case c = read_case(options.case_file, options.sets);
  const auto output = output_path(options);
  require_folder(output);
  const FileLock lock(output, options.wait);
  require_room(options, output);
  const CaseModel model = build_model(c);

  std::optional<Sensitivities> sensitivities;
  if (!c.sensitivities.empty()) sensitivities.emplace(c, model);

  const InterruptGuard guard;
  Recorder recorder(c, model, {output, options.resume}, step_columns(c.analysis),
                    c.analysis == Analysis::dynamics ? c.output.frame_times.size() : 32, clock);
  if (c.analysis != Analysis::dynamics)
    for (const auto& obstacle : c.obstacles)
      if (obstacle.friction > 0)
        recorder.warn(fmt::format("friction acts in dynamics only: '{}' is smooth here", obstacle.name));
  warn_of_rounding(model, recorder);
  if (sensitivities) recorder.differentiate(*sensitivities);
  AnalysisEnd end;
  nlohmann::json summary;
  {
    Progress progress(options.verbosity);
    progress.say(fmt::format("{}: {} nodes, {} unknowns, {}", c.title, model.mesh.nodes(),
                             model.system->unknowns().size(), to_string(c.analysis)));
    try {
      end = run_analysis(c, model, recorder, progress);
    } catch (const FileError&) {  // the result itself cannot be written
      throw;
    } catch (const std::system_error&) {
      throw;
    } catch (const std::runtime_error& problem) {  // a library's call failed: what was computed is finished properly
      end = {ResultStatus::failed, problem.what()};
    }
    report_extremes(c, recorder);
    recorder.statistic("wall_seconds", recorder.clock().wall(), "wall-clock time [s]");
    recorder.statistic("cpu_seconds", recorder.clock().cpu(), "processor time, all threads [s]");
    recorder.finish(end.status, end.message);
    summary = recorder.summary(to_string(end.status), end.message);
    progress.say(report(summary, output));
  }
  if (options.summary) write_text(*options.summary, summary.dump(2) + "\n");
  if (end.status != ResultStatus::done) fmt::print(stderr, "{}: {}\n", options.case_file.string(), end.message);
  if (end.status == ResultStatus::interrupted) return ExitStatus::interrupted;
  return end.status == ResultStatus::done ? ExitStatus::done : ExitStatus::failed;
}

}  // namespace sundrape

#pragma once
#include "sundrape/app/model.hpp"
#include "sundrape/app/progress.hpp"
#include "sundrape/app/recorder.hpp"

namespace sundrape {

/// How an analysis ended; the message says why unless it was done.
struct AnalysisEnd {
  ResultStatus status = ResultStatus::done;
  std::string message;
};

/// Motion in time by the integrator that the case names, with frames, steps and checkpoints going to `recorder`.
[[nodiscard]] AnalysisEnd run_dynamics(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress);

/// Static equilibrium by damped motion, or by the chapter's own scheme.
[[nodiscard]] AnalysisEnd run_relaxation(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress);

/// Equilibria at chosen times of supports and obstacles that move, each relaxed from the one before.
[[nodiscard]] AnalysisEnd run_quasi_static(const Case& c, const CaseModel& model, Recorder& recorder,
                                           Progress& progress);

/// A path of equilibria by arc-length or load steps, stage by stage.
[[nodiscard]] AnalysisEnd run_arc_length(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress);

}  // namespace sundrape

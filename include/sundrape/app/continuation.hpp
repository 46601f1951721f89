#pragma once
#include <functional>
#include <optional>
#include <string>

#include "sundrape/app/coarser_case.hpp"
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

/// What the equilibria on coarser meshes say about that of a case.
struct CoarseStart {
  Vector q;              // 3P of the case's own mesh [m]
  double time = 0;       // of the fictitious motion so far [s]
  double step_size = 0;  // with which to go on [s]
  int meshes = 0, iterations = 0, factorizations = 0;
  bool stopped = false;      // the observer wanted to: q is as far as it came
  std::string problem = {};  // a coarser mesh has not come to rest: no q
};

/// Relaxes the coarsest mesh from its placed sheet and each finer one from the one before.
/// @param coarser  as coarser_cases() has them, not empty
/// @param observe  called after every step with the mesh on which it was taken
[[nodiscard]] CoarseStart start_on_coarser_meshes(
    const Case& c, const CaseModel& model, const std::vector<CoarserCase>& coarser,
    const std::function<void(const QuadMesh&, const RelaxationStep&)>& observe,
    const std::function<bool()>& wants_to_stop);

/// Limits for a relaxation that starts near its end: the energy may rise by no more than a fiftieth of what it may from
/// a flat sheet.
[[nodiscard]] RelaxationOptions continued_options(const Case& c, const CaseModel& model);

/// A state of one mesh on another of the same sheet: positions interpolated smoothly, directors too and of their
/// length; held components stay where the finer mesh's supports have them.
/// @param q  3P of `from` [m]
[[nodiscard]] Vector carried(const CaseModel& from, ConstVectorRef q, const CaseModel& to);

}  // namespace sundrape

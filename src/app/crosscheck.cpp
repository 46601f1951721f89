#include "sundrape/app/crosscheck.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/app/crosscheck_report.hpp"
#include "sundrape/app/rest_watch.hpp"
#include "sundrape/app/run_batch.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_reader.hpp"

#include "crosscheck_methods.hpp"
#include "write_text.hpp"

namespace sundrape {
namespace {

namespace fs = std::filesystem;
using Settings = std::vector<std::string>;

Settings operator+(Settings a, const Settings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

using Verdict = MethodPair::Verdict;

/// Whether an end can be held against another one.
bool has_arrived(const MethodEnd& first, const MethodEnd& second) {
  return second.end->residual <= RestWatch::balanced && second.end->negative_pivots == first.end->negative_pivots;
}

/// Crosschecks choose the analyses themselves.
void refuse_analysis(const Settings& sets) {
  for (const auto& set : sets)
    if (set.starts_with("analysis="))
      throw CaseError("--set " + set, 0, "analysis",
                      "a crosscheck runs every analysis; choose among them by --methods");
}

void refuse_pieces(const Case& c) {
  if (c.pieces.size() > 1)
    throw CaseError({.file = c.file.string(), .key = "cloth"},
                    "a crosscheck looks for the shapes of one sheet: check the pieces of this case one by one");
}

void refuse_grips(const Case& c) {
  const auto refuse = [](const auto& support) {
    if (!support.grip.always())
      throw CaseError(support.source,
                      "a crosscheck holds motion against statics, which know no `grip` and no `release`: there is "
                      "nothing to check this case against");
  };
  std::ranges::for_each(c.fixes, refuse);
  std::ranges::for_each(c.motions, refuse);
}

/// One crosscheck as it goes on.
class Work {
 public:
  explicit Work(const CrosscheckOptions& options)
      : options_(options), case_(read_case(options.case_file, options.sets)), model_(perfect_model(case_)) {
    refuse_pieces(case_);
    refuse_grips(case_);
    batch_ = {
        .case_file = options.case_file,
        .folder = options.folder.value_or(options.case_file.stem().string() + "-crosscheck"),
        .executor = {.kind = ExecutorKind::local, .jobs = options.jobs, .slurm_options = {}, .dask_scheduler = {}},
        .verbosity = options.verbosity};
    check_.title = case_.title;
    check_.diagonal = diagonal(model_.mesh);
    check_.size = model_.size;
    check_.energy_scale = model_.nominal_weight() * model_.size;
  }

  ExitStatus run() {
    if (!run_methods()) return interrupted();
    compare_ends();
    if (!relax_others()) return interrupted();
    write_text(batch_.folder / "crosscheck.txt", crosscheck_text(check_));
    write_text(batch_.folder / "crosscheck.json", crosscheck_json(check_, model_.mesh.nodes()).dump(1) + "\n");
    if (options_.verbosity != Verbosity::quiet) {
      std::cout << crosscheck_text(check_);
      fmt::print("a picture of it: python3 -m sundrape_postproc crosscheck {} -o {}\n", batch_.folder.string(),
                 (batch_.folder / "crosscheck.png").string());
    }
    const bool failed = std::ranges::any_of(check_.methods, [](const auto& m) { return !m.end; }) ||
                        std::ranges::any_of(check_.pairs, [](const auto& p) { return p.relaxed && !p.relaxed->end; });
    return failed ? ExitStatus::failed : ExitStatus::done;
  }

 private:
  [[nodiscard]] ExitStatus interrupted() const {
    fmt::print(stderr, "{}: interrupted: the same command goes on\n", options_.case_file.string());
    return ExitStatus::interrupted;
  }

  /// An end after the symmetry and the neutral motion that lay it on another one.
  [[nodiscard]] EndState laid_on(const EndState& end, const ShapeDistance& apart) const {
    Vector forces = symmetries_.maps[apart.map].turn(end.held_forces);
    for (int p = 0; p < static_cast<int>(forces.size() / 3); ++p) point(forces, p) = apart.turn * point(forces, p);
    return moved(end, model_, apart.aligned, std::move(forces));
  }

  static bool was_interrupted(const std::vector<BatchOutcome>& outcomes) {
    return std::ranges::count(outcomes, BatchStatus::interrupted, &BatchOutcome::status) > 0;
  }

  /// False if interrupted.
  bool run_methods() {
    std::vector<BatchRun> runs;
    for (const auto& method : crosscheck_methods(case_, model_)) {
      const auto& wanted = options_.methods;
      if (!wanted.empty() && std::ranges::find(wanted, method.name) == wanted.end()) continue;
      runs.push_back(
          {method.name, common_settings(case_) + method.sets + options_.sets + Settings{"analysis=" + method.name}});
    }
    const auto outcomes = run_batch(runs, batch_);
    if (was_interrupted(outcomes)) return false;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      MethodEnd method{runs[i].name, outcomes[i].result, outcomes[i].message, {}, {}};
      if (outcomes[i].status == BatchStatus::done) {
        const ResultReader result(outcomes[i].result);
        method.end = end_state(weighing_model(read_case(options_.case_file, runs[i].sets)), result);
        method.warnings = result.warnings();
        const double last = result.frame_values().back();
        if (result.frame_variable() == FrameVariable::load_factor && std::abs(last - 1) > 1e-6)
          method.warnings.push_back(fmt::format("ended at a load factor of {:.6g}, not under the whole load", last));
      }
      check_.methods.push_back(std::move(method));
    }
    return true;
  }

  void compare_ends() {
    std::vector<Vector> ends;
    for (const auto& method : check_.methods)
      if (method.end) ends.push_back(method.end->q);
    symmetries_ = find_case_symmetries(model_, ends);
    check_.symmetries = symmetries_.maps.size();
    const auto& methods = check_.methods;
    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(methods, [](const auto& m) { return m.end.has_value(); }) - methods.begin());
    for (std::size_t second = first + 1; second < methods.size(); ++second) {
      if (!methods[second].end) continue;
      MethodPair pair{.first = first, .second = second, .apart = {}, .laid_on = {}, .relaxed = {}};
      pair.apart = shape_distance(symmetries_, model_.mesh.nodes(), methods[first].end->q, methods[second].end->q);
      pair.laid_on = laid_on(*methods[second].end, pair.apart);
      if (check_.is_one_branch(pair.apart.rms)) pair.verdict = Verdict::same_branch;
      check_.pairs.push_back(std::move(pair));
    }
  }

  /// Relaxes ends that are not where the first method's is, from where they are. False if interrupted.
  bool relax_others() {
    std::vector<BatchRun> runs;
    std::vector<MethodPair*> pairs;
    for (auto& pair : check_.pairs) {
      if (pair.verdict == Verdict::same_branch) continue;
      const auto& method = check_.methods[pair.second];
      runs.push_back(
          {method.name + "-relaxed", options_.sets + Settings{"analysis=relaxation", "cloth.waviness={ amplitude = 0 }",
                                                              "cloth.start=" + fs::absolute(method.result).string()}});
      pairs.push_back(&pair);
    }
    if (runs.empty()) return true;
    const auto outcomes = run_batch(runs, batch_);
    if (was_interrupted(outcomes)) return false;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      MethodPair::Relaxed relaxed{.result = outcomes[i].result, .failure = outcomes[i].message, .end = {}};
      if (outcomes[i].status == BatchStatus::done) {
        relaxed.end =
            end_state(weighing_model(read_case(options_.case_file, runs[i].sets)), ResultReader(outcomes[i].result));
        const auto& start = check_.methods[pairs[i]->second].end->q;
        const auto moved = shape_distance({{symmetries_.maps.front()}, symmetries_.neutral}, model_.mesh.nodes(), start,
                                          relaxed.end->q);
        relaxed.moved_rms = moved.rms;
        relaxed.moved_max = moved.max;
        const auto& first = check_.methods[pairs[i]->first].end->q;
        relaxed.apart_rms = shape_distance(symmetries_, model_.mesh.nodes(), first, relaxed.end->q).rms;
        if (has_arrived(check_.methods[pairs[i]->first], check_.methods[pairs[i]->second]))
          pairs[i]->verdict = check_.is_one_branch(relaxed.apart_rms) ? Verdict::same_branch : Verdict::other_branch;
      }
      pairs[i]->relaxed = std::move(relaxed);
    }
    return true;
  }

  const CrosscheckOptions& options_;
  Case case_;
  CaseModel model_;
  BatchOptions batch_;
  Crosscheck check_;
  CaseSymmetries symmetries_;
};

}  // namespace

ExitStatus run_crosscheck(const CrosscheckOptions& options) {
  refuse_analysis(options.sets);
  return Work(options).run();
}

}  // namespace sundrape

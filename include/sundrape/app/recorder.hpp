#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "sundrape/app/model.hpp"
#include "sundrape/app/run_clock.hpp"
#include "sundrape/app/sensitivities.hpp"
#include "sundrape/integrate/energy_audit.hpp"
#include "sundrape/io/result_writer.hpp"
#include "sundrape/io/xdmf.hpp"

namespace sundrape {

/// What a run has seen at its worst since its start, for the summary and for warnings.
struct Extremes {
  double largest_edge_strain = 0, smallest_edge_strain = 0;  // over all frames
  double deepest_penetration = 0;                            // over all accepted steps [m]
  double sharpest_bend = 0;                                  // over all frames [rad]
  double largest_membrane_strain = 0;  // of a shell at the centres of its elements, over all frames
};

/// Turns states of a model into frames, probes and checkpoints of a result file, and keeps score of the extremes.
class Recorder {
 public:
  struct Files {
    std::filesystem::path output;
    std::optional<std::filesystem::path> resume;
  };

  /// A resumed run goes on with the earlier one's extremes, warnings, last frame and times.
  /// @throws FileError  also if what is to be resumed has no checkpoint, or another mesh or analysis
  Recorder(const Case& c, const CaseModel& model, const Files& files, std::vector<StepColumn> columns,
           std::uint64_t expected_frames, RunClock clock = {});

  /// Has frames hold derivatives too: of equilibria by themselves, of motions as given to frame().
  void differentiate(Sensitivities& sensitivities) { sensitivities_ = &sensitivities; }
  /// Null unless the case asks for derivatives.
  [[nodiscard]] Sensitivities* sensitivities() const { return sensitivities_; }

  /// A frame whose negative pivots are known is one of an equilibrium.
  /// @param residual  where the analysis knows it better than by the loads of the moment
  void frame(const State& all, const EnergyAudit::Balance& balance, std::optional<int> negative_pivots = std::nullopt,
             std::optional<double> residual = std::nullopt, std::vector<FrameSensitivity> derivatives = {});
  /// Probes and extremes of an accepted step; returns how the cloth stands to its obstacles.
  ContactReport step(const State& all);
  void step_values(std::initializer_list<ResultWriter::StepValue> values) { writer_.append_step(values); }
  void iteration(const ResultWriter::PathIteration& iteration) { writer_.append_iteration(iteration); }
  void critical_point(const CriticalRecord& point) { writer_.append_critical_point(point); }
  /// @param totals    what the analysis counts, in its own order and always as many
  /// @param schedule  of supports that change in time (SupportSchedule)
  /// @param sensitivities  of a motion: where they are, as the analysis lists them
  void checkpoint(const State& all, const EnergyAudit::Balance& balance, double initial_energy, double step_size,
                  const std::vector<double>& totals, const std::vector<double>& schedule = {},
                  const std::vector<double>& sensitivities = {});
  /// What an interrupted run left, if this one resumes it.
  struct Restart {
    double time = 0;
    Vector q, v;  // 3N
    EnergyAudit::Balance balance;
    double initial_energy = 0, step_size = 0;
    std::vector<double> totals;  // as given to checkpoint()
    Extremes extremes;
    double wall = 0, cpu = 0;  // [s]
    std::vector<double> schedule, sensitivities;
  };
  [[nodiscard]] const std::optional<Restart>& restart() const { return restart_; }

  /// Once a run, however often it is said.
  void warn(const std::string& text);
  void statistic(const std::string& name, StatisticValue value, const std::string& description);
  /// Statistics and extremes so far as JSON, with what describes the run.
  [[nodiscard]] nlohmann::json summary(const std::string& status, const std::string& message) const;
  void finish(ResultStatus status, const std::string& message);

  [[nodiscard]] const RunClock& clock() const { return clock_; }
  [[nodiscard]] const Extremes& extremes() const { return extremes_; }
  /// Time or load factor of the first frame, since the start or a resume, in which cloth intersects cloth.
  [[nodiscard]] const std::optional<double>& first_crossing() const { return first_crossing_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] std::uint64_t frames() const { return writer_.frames(); }

 private:
  const Case& case_;
  const CaseModel& model_;
  ResultHeader header_;
  RunClock clock_;
  std::optional<Restart> restart_;
  ResultWriter writer_;
  XdmfWriter xdmf_;
  Extremes extremes_;
  Sensitivities* sensitivities_ = nullptr;
  std::optional<double> first_crossing_;
  Frame last_;
  std::vector<std::string> warnings_;
  std::vector<Statistic> statistics_;
};

}  // namespace sundrape

#pragma once
#include <vector>

#include "sundrape/integrate/energy_audit.hpp"
#include "sundrape/integrate/forward_sensitivity.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/integrate/timetable.hpp"

namespace sundrape {

/// What a run tells those who write results or show progress. States are of all points.
class DynamicsObserver {
 public:
  virtual ~DynamicsObserver() = default;
  virtual void frame(const State& all, const EnergyAudit::Balance& balance) = 0;
  virtual void step(const State& all, const StepReport& report, const Integrator& integrator) = 0;
  /// Asked after every step: true ends the run there.
  [[nodiscard]] virtual bool wants_to_stop() = 0;
};

enum class DynamicsEnd { reached, stopped };

/// Carries a system from its start through all frame times with one integrator, letting events happen on the way.
class Dynamics {
 public:
  /// @param frame_times  ascending; the last is the end of the run [s]
  Dynamics(const System& system, Integrator& integrator, std::vector<double> frame_times, DynamicsObserver& observer,
           EventSource* events = nullptr, Timetable* timetable = nullptr);

  /// Has sensitivities follow every step; call before run().
  void carry(ForwardSensitivity& sensitivity) { sensitivity_ = &sensitivity; }

  /// From a state of all points; frames at or before `time` are taken as written unless `first_frame` asks for the one
  /// at `time`.
  /// @throws IntegrationFailure
  DynamicsEnd run(double time, ConstVectorRef q, ConstVectorRef v, bool first_frame);

  /// The state that the last accepted step ended with.
  [[nodiscard]] State last() const { return {time_, q_, v_}; }
  [[nodiscard]] EnergyAudit& audit() { return *audit_; }
  /// Books carried over from before a restart; call before run().
  void carry_over(const EnergyAudit::Balance& before, double initial_energy);

 private:
  void expand_last();
  /// Gathers the unknowns from the last state and starts the integrator there.
  void restart();
  [[nodiscard]] bool is_due() const { return timetable_ != nullptr && timetable_->next() <= time_; }
  void let_supports_change();
  void emit_frames(std::size_t& next);

  const System& system_;
  Integrator& integrator_;
  std::vector<double> frame_times_;
  DynamicsObserver& observer_;
  EventSource* events_;
  Timetable* timetable_;
  ForwardSensitivity* sensitivity_ = nullptr;
  double time_ = 0;
  Vector q_, v_;              // all points, after the last step
  Vector frame_q_, frame_v_;  // all points, of a frame
  Vector rows_q_, rows_v_;    // unknowns, work
  std::unique_ptr<EnergyAudit> audit_;
  std::optional<std::pair<EnergyAudit::Balance, double>> carried_;
};

}  // namespace sundrape

#pragma once
#include <optional>

#include "sundrape/app/progress.hpp"
#include "sundrape/app/recorder.hpp"
#include "sundrape/app/stop_request.hpp"
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

/// Turns the steps of a relaxation into frames, checkpoints and progress, and ends it when its time is over.
class RelaxationWatch final : public RelaxationObserver {
 public:
  RelaxationWatch(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress, double first_step);

  void step(const State& all, const RelaxationStep& step) override;
  /// A step on another mesh than the case's: shown, not recorded.
  void coarse_step(const QuadMesh& mesh, const RelaxationStep& step);
  [[nodiscard]] bool wants_to_stop() override { return stop_.wanted(); }
  [[nodiscard]] bool out_of_time() const { return stop_.out_of_time(); }

  /// Steps that come begin anew from `q`, a later state than all so far; it gets a frame and a checkpoint.
  void begin_again(const Vector& q, double time, double step_size);

  /// How far the relaxation is, from its very start.
  struct Course {
    double time = 0, step_size = 0;  // of the fictitious motion [s]
    double iterations = 0, factorizations = 0;
  };
  [[nodiscard]] const Course& now() const { return now_; }
  /// Whether this state has no frame yet.
  [[nodiscard]] bool is_new() const { return is_new_; }

  void frame(const Vector& q, std::optional<int> pivots = std::nullopt);
  void checkpoint(const Vector& q);

 private:
  [[nodiscard]] EnergyAudit::Balance balance_of(const State& all) const;

  const Case& case_;
  const CaseModel& model_;
  Recorder& recorder_;
  Progress& progress_;
  Vector still_;
  double initial_load_;
  StopRequest stop_;
  Course before_, now_;
  std::optional<Vector> due_;  // positions that wait to become a frame
  bool is_new_ = false;
  int steps_ = 0;
};

}  // namespace sundrape

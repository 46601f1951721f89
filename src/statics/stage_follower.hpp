#pragma once
#include "critical_point.hpp"

namespace sundrape {

/// Follows the path through one stage: predicts, corrects and accepts step after step, and deals with what is met on
/// the way. `at` is where it is, always an equilibrium.
class StageFollower {
 public:
  /// All are kept by reference.
  StageFollower(const System& system, Tangent& tangent, const PathOptions& options, PathPosition& at,
                PathObserver& observer);

  [[nodiscard]] PathResult run();

 private:
  using Failure = std::optional<PathResult>;

  /// Where forces do not balance without load (cloth that lies on an obstacle), the first increment is put on at once.
  Failure begin();
  Failure step();
  /// Factors the tangent here and keeps what it says; false where it is singular.
  bool assess();
  /// Length of the next step (20), and limits on it.
  [[nodiscard]] double predicted_length(double norm) const;
  /// From the prediction `to` to equilibrium, `length` from here or under the full load.
  Correction correct(PathPoint& to, double length);
  /// From an equilibrium beyond the full load to one under it.
  Correction back_to_full_load(PathPoint& to);
  /// Whether a step would lead cloth through cloth.
  [[nodiscard]] bool passes(const PathPoint& to) const;
  /// Whether a step has gone another way than predicted.
  [[nodiscard]] bool strays(const PathPoint& to, double sense) const;
  /// @param length  of the step; 0: whatever it comes to
  void accept(const PathPoint& to, const Correction& found, int halvings, double length);
  /// What to do about the step that was accepted last.
  Failure after_step();
  /// Critical points that the last step has passed.
  Failure meet_critical_points();
  Failure switch_branch(const CriticalPoint& bifurcation);
  /// To the stable equilibrium that cloth goes to under a load when it has lost its stability, or its path has ended.
  Failure fall(double load_factor);
  /// The same under more load than here, where the path creeps or ends.
  Failure fall_further(double increment);
  /// Says so if the last step may have left the path.
  /// @param predicted  largest move of a coordinate [m]
  void doubt(const Correction& found, double predicted, bool first);
  /// What comes next is a first step, towards more load.
  void begin_anew();

  void count_factorizations();
  [[nodiscard]] PathResult stall(const std::string& what, const std::string& advice) const;
  [[nodiscard]] PathPoint here() const { return {at_.q, at_.load_factor}; }
  [[nodiscard]] ResidualReport report();

  const System& system_;
  const PathOptions& options_;
  PathPosition& at_;
  PathObserver& observer_;
  StageSolver solver_;
  double first_increment_, fall_increment_ = 0;  // of the load factor
  int short_steps_ = 0;                          // in a row, while falling is allowed
  long counted_factorizations_;                  // of the tangent, by now in at_

  bool assessed_ = false;      // whether the following are those of `at`
  Vector by_load_;             // u^I, rows
  std::optional<int> pivots_;  // negative ones
  bool forward_ = true;        // towards more load

  bool was_forward_ = true;              // before the last step
  std::optional<AssessedPoint> before_;  // where that began; nothing where its pivots are not known
};

}  // namespace sundrape

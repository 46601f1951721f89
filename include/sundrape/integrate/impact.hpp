#pragma once
#include <vector>

#include "sundrape/force/obstacle_contact.hpp"
#include "sundrape/integrate/events.hpp"

namespace sundrape {

/// Classical impact of nodes on obstacles by a coefficient of restitution (chapter §3.3).
///
/// When a node comes within the reach of the contact force with a normal velocity v_n < −`smallest_speed`, it leaves at
/// once with −e v_n; tangential velocity is kept, and neighbours are not asked. Slower nodes are left to the penalty
/// force, which carries what rests. ½ m (1 − e²) v_n² is booked as dissipated.
class Impact final : public EventSource {
 public:
  /// @param mass  of each node [kg], N
  /// @throws std::invalid_argument  e outside [0, 1], or a smallest speed that is not positive
  Impact(const ObstacleContact& contact, Vector mass, double restitution, double smallest_speed);

  [[nodiscard]] int count() const override { return static_cast<int>(mass_.size()); }
  void evaluate(const State& all, std::span<double> values) const override;
  bool happen(double time, ConstVectorRef q, VectorRef v, std::span<const int> fired) override;
  void accepted(const State& all) override;
  [[nodiscard]] double dissipated() const override { return dissipated_; }

 private:
  [[nodiscard]] double distance_to_reach(const State& all, int node) const;

  const ObstacleContact& contact_;
  Vector mass_;
  double restitution_, smallest_speed_;
  std::vector<bool>
      carried_;  // nodes that the penalty force has; they have no impact until they are twice the reach away
  double dissipated_ = 0;
};

}  // namespace sundrape

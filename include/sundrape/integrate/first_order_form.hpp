#pragma once
#include "sundrape/integrate/events.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape {

/// The system as  ẏ = (v, M⁻¹ f)  with y = (q, v) over the unknowns, 6n. Owns the work space of the evaluation.
class FirstOrderForm {
 public:
  explicit FirstOrderForm(const System& system);

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] Eigen::Index size() const { return 2 * system_.unknowns().size(); }
  [[nodiscard]] long evaluations() const { return evaluations_; }

  /// forces over the unknowns (3n) [N]; false if the result is not finite.
  bool forces(double time, ConstVectorRef y, VectorRef f);
  /// ẏ (6n), the acceleration of points without mass being given as 0; false if the result is not finite.
  bool rates(double time, ConstVectorRef y, VectorRef y_dot);
  /// Values of the events at y.
  void events(double time, ConstVectorRef y, const EventSource& source, std::span<double> values);

 private:
  const System& system_;
  Vector q_, v_, f_;  // all points
  long evaluations_ = 0;
};

}  // namespace sundrape

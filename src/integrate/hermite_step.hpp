#pragma once
#include "sundrape/types.hpp"

namespace sundrape {

/// The last step of a one-step method as the cubic that has the states and rates of its ends: error h⁴/384 |y⁗|.
class HermiteStep {
 public:
  struct End {
    double time = 0;  // [s]
    Vector y, rates;
  };

  /// From here on, with no step yet: y and ẏ.
  void start_from(End end);
  /// The next step has ended.
  void advance(double time, ConstVectorRef y, ConstVectorRef rates);

  [[nodiscard]] const End& end() const { return end_; }
  /// y at a time within the step.
  void interpolate(double time, VectorRef y) const;
  /// y at a time beyond the step: by the parabola through both states that has the last rate, or, with no step yet, by
  /// that rate alone.
  void extrapolate(double time, VectorRef y) const;

 private:
  End begin_, end_;
};

}  // namespace sundrape

#pragma once
#include "sundrape/types.hpp"

namespace sundrape {

/// How large an error of a step may be in each unknown.
///
/// A coordinate may err by rtol |u| + atol_position, u being how far its point has come from the start, a rate by
/// rtol |v| + atol_velocity, v being its point's rate: independent of where the origin is and how the axes are turned.
struct ErrorWeights {
  double rtol;
  double atol_position;    // [m]
  double atol_velocity;    // [m/s]
  Vector start;            // rows, 3n: coordinates when the integrator was first started
  Vector rate_slack = {};  // rows, n: how many times larger the errors of rates may be; empty: 1

  /// weights (6n, reciprocal allowed errors) of y = (q, v) (6n).
  void evaluate(ConstVectorRef y, VectorRef weights) const;
};

}  // namespace sundrape

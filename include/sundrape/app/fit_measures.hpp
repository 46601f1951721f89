#pragma once
#include "sundrape/app/least_squares.hpp"
#include "sundrape/io/fit.hpp"
#include "sundrape/io/result_reader.hpp"

namespace sundrape {

/// Holds what was measured against what a run of the case says.
class FitMeasures {
 public:
  /// @throws CaseError  nodes of a curve that are not there, or without an edge between them
  explicit FitMeasures(const Fit& fit);

  /// Measured less computed over the standard deviation, number by number in the fit's order, and the derivatives by
  /// the fit's parameters, which the result has to hold.
  /// @throws FileError  the result lacks them, or a frame at the time of a measurement
  [[nodiscard]] LeastSquaresPoint compare(const ResultReader& result) const;

 private:
  using Segment = std::array<int, 2>;  // two nodes

  const Fit& fit_;
  std::vector<std::vector<Segment>> segments_;  // one list a measurement; empty but for curves
};

}  // namespace sundrape

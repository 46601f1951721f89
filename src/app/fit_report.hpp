#pragma once
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sundrape/app/least_squares.hpp"
#include "sundrape/io/fit.hpp"

namespace sundrape {

/// An estimate of one parameter, SI.
struct FitEstimate {
  double value = 0, low = 0, high = 0;  // and the ends of its interval
  double relative_error = 0;            // standard error over the value
};

/// What a fit has found.
struct FitOutcome {
  LeastSquaresResult search;
  LeastSquaresUncertainty uncertainty;
  std::vector<FitEstimate> estimates;
  std::vector<std::string> warnings;
};

[[nodiscard]] FitOutcome fit_outcome(const Fit& fit, LeastSquaresResult search);
/// For people.
[[nodiscard]] std::string fit_text(const Fit& fit, const FitOutcome& outcome);
[[nodiscard]] nlohmann::json fit_json(const Fit& fit, const FitOutcome& outcome);
[[nodiscard]] const char* to_string(LeastSquaresResult::End end);
/// A parameter's value from what the search varies: itself, or its logarithm.
[[nodiscard]] double value_of(const FitParameter& parameter, double varied);

}  // namespace sundrape

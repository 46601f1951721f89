#pragma once
#include <functional>
#include <optional>
#include <string>

#include "sundrape/types.hpp"

namespace sundrape {

/// What a model says at some values of its parameters: weighted residuals r, and their derivatives J = ∂r/∂θ.
struct LeastSquaresPoint {
  Vector residuals;          // n
  Eigen::MatrixXd jacobian;  // n × p
  [[nodiscard]] double chi_squared() const { return residuals.squaredNorm(); }
};

/// One try of the search.
struct LeastSquaresStep {
  int iteration = 0;
  const Vector& at;        // θ tried, p
  double chi_squared = 0;  // there; infinite where the model has no answer
  double damping = 0;      // λ
  bool accepted = false;
};

struct LeastSquaresOptions {
  Vector lower, upper;  // bounds of θ, p
  Vector scale;         // sizes of θ, p
  double tolerance = 1e-2;
  int max_iterations = 30;
};

struct LeastSquaresResult {
  enum class End { converged, stalled, out_of_iterations, stopped };
  End end = End::converged;
  Vector at;  // θ, p
  LeastSquaresPoint point;
  int iterations = 0;  // evaluations of the model
};

/// Gauss–Newton with Levenberg–Marquardt damping (Marquardt 1963; Nielsen's rule for the damping) within bounds:
///     (JᵀJ + λ diag JᵀJ) Δθ = −Jᵀ r,
/// parameters that press against a bound being left out of a step. Ends once a full step would change every parameter
/// by less than `tolerance` of its standard error, or by less than 10⁻⁵ of its size.
/// @param evaluate  nothing where the model has no answer: the step is tried again, shorter
/// @param observe   after every try; false stops the search
/// @throws std::runtime_error  the model has no answer at the start
[[nodiscard]] LeastSquaresResult minimise(
    const Vector& start, const LeastSquaresOptions& options,
    const std::function<std::optional<LeastSquaresPoint>(const Vector&)>& evaluate,
    const std::function<bool(const LeastSquaresStep&)>& observe);

/// What a solution says about its parameters.
struct LeastSquaresUncertainty {
  Vector standard_error;         // of θ, p; infinite for a parameter that the data do not tell
  Eigen::MatrixXd correlation;   // p × p
  double quantile = 0;           // standard errors from the value to the interval's ends
  double residual_variance = 1;  // s²: χ²/(n − p), or 1 where n = p
  bool by_residuals = false;     // whether s² is that of the residuals, rather than the standard deviations as given
  double reciprocal_condition = 0;  // of JᵀJ with unit diagonal
};

/// From s² (JᵀJ)⁻¹ and Student's t with n − p degrees of freedom; with n = p from the given standard deviations alone,
/// and the normal distribution.
/// @param confidence  of the intervals, in (0, 1)
[[nodiscard]] LeastSquaresUncertainty uncertainty(const LeastSquaresPoint& point, double confidence);

}  // namespace sundrape

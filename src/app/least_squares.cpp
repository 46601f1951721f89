#include "sundrape/app/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace sundrape {
namespace {

constexpr double first_damping = 1e-3, largest_damping = 1e8;
constexpr double least_change = 1e-5;  // over a parameter's scale: what runs leave out of balance shows below
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Which parameters may move: all but those that lie on a bound and are drawn beyond it.
std::vector<Eigen::Index> free_parameters(const Vector& at, const Vector& gradient, const LeastSquaresOptions& o) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < at.size(); ++i)
    if (!(at[i] <= o.lower[i] && gradient[i] > 0) && !(at[i] >= o.upper[i] && gradient[i] < 0)) free.push_back(i);
  return free;
}

/// Δθ of the damped normal equations, and how much they say χ² falls.
struct Step {
  Vector way;
  double predicted_fall = 0;
};
Step damped_step(const LeastSquaresPoint& point, const Vector& at, double damping, const LeastSquaresOptions& o) {
  const Vector gradient = point.jacobian.transpose() * point.residuals;
  const auto free = free_parameters(at, gradient, o);
  Step step{Vector::Zero(at.size())};
  if (free.empty()) return step;
  const Eigen::MatrixXd j = point.jacobian(Eigen::all, free);
  const Eigen::MatrixXd normal = j.transpose() * j;
  Eigen::MatrixXd damped = normal;
  // a parameter without any influence stays where it is
  damped.diagonal() += damping * normal.diagonal() + Vector::Constant(normal.rows(), 1e-300);
  const Vector g = gradient(free);
  const Vector way = damped.ldlt().solve(-g);
  step.way(free) = way;
  step.way = (at + step.way).cwiseMax(o.lower).cwiseMin(o.upper) - at;
  const Vector linear = point.jacobian * step.way;
  step.predicted_fall = -(2 * point.residuals.dot(linear) + linear.squaredNorm());
  return step;
}

bool is_small(const Vector& way, const LeastSquaresPoint& point, const LeastSquaresOptions& o) {
  const auto degrees = static_cast<double>(point.residuals.size() - way.size());
  const double deviation = degrees > 0 ? std::sqrt(point.chi_squared() / degrees) : 1;
  for (Eigen::Index i = 0; i < way.size(); ++i) {
    const double influence = point.jacobian.col(i).norm();
    // the error that the parameter would have alone, which is the least that it can have
    const double error = influence > 0 ? deviation / influence : 0;
    if (std::abs(way[i]) > std::max(o.tolerance * error, least_change * o.scale[i])) return false;
  }
  return true;
}

}  // namespace

LeastSquaresResult minimise(const Vector& start, const LeastSquaresOptions& options,
                            const std::function<std::optional<LeastSquaresPoint>(const Vector&)>& evaluate,
                            const std::function<bool(const LeastSquaresStep&)>& observe) {
  using End = LeastSquaresResult::End;
  LeastSquaresResult result{.end = End::converged, .at = start, .point = {}, .iterations = 1};
  auto first = evaluate(start);
  if (!first) throw std::runtime_error("the case cannot be run with the start values");
  result.point = std::move(*first);
  double damping = first_damping, growth = 2;
  bool go_on = observe({1, result.at, result.point.chi_squared(), damping, true});
  while (true) {
    const auto full = damped_step(result.point, result.at, 0, options);
    if (is_small(full.way, result.point, options)) return result;
    if (!go_on || result.iterations >= options.max_iterations) {
      result.end = go_on ? End::out_of_iterations : End::stopped;
      return result;
    }
    const auto step = damped_step(result.point, result.at, damping, options);
    const Vector tried = result.at + step.way;
    auto point = evaluate(tried);
    ++result.iterations;
    const double before = result.point.chi_squared(), now = point ? point->chi_squared() : infinity;
    const bool better = now < before;
    go_on = observe({result.iterations, tried, now, damping, better});
    if (better) {
      const double gain = (before - now) / step.predicted_fall;
      damping *= std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3));
      growth = 2;
      result.at = tried;
      result.point = std::move(*point);
    } else {
      damping = std::max(damping, first_damping) * growth;
      growth *= 2;
      if (is_small(step.way, result.point, options)) return result;  // rounding hides what is left to gain
      if (damping > largest_damping) {
        result.end = End::stalled;
        return result;
      }
    }
  }
}

LeastSquaresUncertainty uncertainty(const LeastSquaresPoint& point, double confidence) {
  const Eigen::Index n = point.residuals.size(), p = point.jacobian.cols();
  LeastSquaresUncertainty u;
  const double upper = 0.5 * (1 + confidence);
  u.by_residuals = n > p;
  if (u.by_residuals) {
    u.residual_variance = point.chi_squared() / static_cast<double>(n - p);
    u.quantile = boost::math::quantile(boost::math::students_t(static_cast<double>(n - p)), upper);
  } else {
    u.quantile = boost::math::quantile(boost::math::normal(), upper);
  }
  const Vector influence = point.jacobian.colwise().norm();
  const Vector inverse = influence.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
  const Eigen::MatrixXd scaled = point.jacobian * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaled.transpose() * scaled);
  const Vector& values = modes.eigenvalues();
  u.reciprocal_condition = std::max(0.0, values.minCoeff()) / values.maxCoeff();
  u.standard_error = Vector::Constant(p, infinity);
  u.correlation = Eigen::MatrixXd::Identity(p, p);
  constexpr double singular = 1e-14;
  if (u.reciprocal_condition > singular) {
    const Eigen::MatrixXd covariance =
        modes.eigenvectors() * values.cwiseInverse().asDiagonal() * modes.eigenvectors().transpose();
    for (Eigen::Index i = 0; i < p; ++i) {
      u.standard_error[i] = std::sqrt(u.residual_variance * covariance(i, i)) * inverse[i];
      for (Eigen::Index k = 0; k < p; ++k)
        u.correlation(i, k) = covariance(i, k) / std::sqrt(covariance(i, i) * covariance(k, k));
    }
  }
  return u;
}

}  // namespace sundrape

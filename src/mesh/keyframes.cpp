#include "sundrape/mesh/keyframes.hpp"

#include <algorithm>
#include <stdexcept>

#include <Eigen/LU>

namespace sundrape {
namespace {

/// Slopes of the cubic spline with zero slopes at both ends: its second derivative is continuous,
///     s_{k−1}/h_{k−1} + 2 s_k (1/h_{k−1} + 1/h_k) + s_{k+1}/h_k = 3 (Δ_{k−1}/h_{k−1}² + Δ_k/h_k²).
Eigen::MatrixXd spline_slopes(const std::vector<double>& times, const Eigen::MatrixXd& values) {
  const auto n = values.cols();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n), right = Eigen::MatrixXd::Zero(n, values.rows());
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double before = 1 / (times[i] - times[i - 1]), after = 1 / (times[i + 1] - times[i]);
    matrix(k, k - 1) = before;
    matrix(k, k) = 2 * (before + after);
    matrix(k, k + 1) = after;
    right.row(k) = 3 * (before * before * (values.col(k) - values.col(k - 1)) +
                        after * after * (values.col(k + 1) - values.col(k)))
                           .transpose();
  }
  return matrix.partialPivLu().solve(right).transpose();
}

}  // namespace

Keyframes::Keyframes(std::vector<double> times, Eigen::MatrixXd values, Between between)
    : times_(std::move(times)), values_(std::move(values)) {
  if (times_.size() < 2 || static_cast<Eigen::Index>(times_.size()) != values_.cols())
    throw std::invalid_argument("keyframes need two or more times, and a value at each");
  if (std::ranges::adjacent_find(times_, std::greater_equal<>()) != times_.end())
    throw std::invalid_argument("the times of keyframes must ascend");
  if (between == Between::smooth) slopes_ = spline_slopes(times_, values_);
}

Keyframes::Place Keyframes::find(double time) const {
  if (time < times_.front()) return {};
  const auto legs = static_cast<Eigen::Index>(times_.size()) - 1;
  if (time >= times_.back()) return {legs - 1, 1, false};
  const auto leg = std::ranges::upper_bound(times_, time) - times_.begin() - 1;
  return {leg, (time - times_[static_cast<std::size_t>(leg)]) / length(leg), true};
}

Vector Keyframes::value(double time) const {
  const auto [k, s, inside] = find(time);
  const Vector way = values_.col(k + 1) - values_.col(k);
  if (slopes_.size() == 0) return values_.col(k) + s * way;
  const double h = length(k), r = 1 - s;  // Hermite's cubics
  return values_.col(k) + s * s * (3 - 2 * s) * way + h * s * r * (r * slopes_.col(k) - s * slopes_.col(k + 1));
}

Vector Keyframes::rate(double time) const {
  const auto [k, s, inside] = find(time);
  if (!inside) return Vector::Zero(values_.rows());
  const Vector way = values_.col(k + 1) - values_.col(k);
  const double h = length(k), r = 1 - s;
  if (slopes_.size() == 0) return way / h;
  return 6 * s * r / h * way + r * (1 - 3 * s) * slopes_.col(k) + s * (3 * s - 2) * slopes_.col(k + 1);
}

}  // namespace sundrape

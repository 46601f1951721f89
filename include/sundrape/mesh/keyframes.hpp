#pragma once
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// A curve through given values at given times, in one or several components: straight from one to the next, or the C²
/// cubic spline that starts and ends at rest. Before the first and after the last time it stays.
class Keyframes {
 public:
  enum class Between { straight, smooth };

  /// @param times   two or more, ascending [s]
  /// @param values  one column a time
  /// @throws std::invalid_argument  times that do not ascend, or another number of values
  Keyframes(std::vector<double> times, Eigen::MatrixXd values, Between between);

  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] const Eigen::MatrixXd& values() const { return values_; }
  [[nodiscard]] Between between() const { return slopes_.size() > 0 ? Between::smooth : Between::straight; }
  [[nodiscard]] Vector value(double time) const;
  [[nodiscard]] Vector rate(double time) const;  // [1/s]

 private:
  struct Place {
    Eigen::Index leg = 0;
    double part = 0;  // of the leg, in [0, 1]
    bool inside = false;
  };
  [[nodiscard]] Place find(double time) const;
  [[nodiscard]] double length(Eigen::Index leg) const {
    const auto k = static_cast<std::size_t>(leg);
    return times_[k + 1] - times_[k];
  }

  std::vector<double> times_;
  Eigen::MatrixXd values_, slopes_;  // slopes_ of the spline at the times; empty where legs are straight
};

}  // namespace sundrape

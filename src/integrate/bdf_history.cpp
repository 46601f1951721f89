#include "sundrape/integrate/bdf_history.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace sundrape {

void BdfHistory::restart(double time) {
  times_.assign(1, time);
  order_ = 1;
}

BdfHistory::Weights BdfHistory::weights(int order, double time, double alpha, double beta) const {
  const bool with_rate = form_ == BdfForm::cvode;
  const int wanted = with_rate ? order : order + 1;
  const int values = std::min(wanted, static_cast<int>(times_.size())), size = values + (with_rate ? 1 : 0);
  // π(t) = Σ a_j x^j with x = (t − t_newest)/h: its coefficients from the conditions, then its value and slope at
  // `time`
  Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(size, size);
  for (int i = 0; i < values; ++i)
    for (int j = 0; j < size; ++j)
      conditions(i, j) = j == 0 ? 1 : std::pow((times_[static_cast<std::size_t>(i)] - times_.front()) / step_, j);
  if (with_rate) conditions(values, 1) = 1 / step_;
  Vector wanted_combination(size);
  const double x = (time - times_.front()) / step_;
  for (int j = 0; j < size; ++j)
    wanted_combination[j] = alpha * std::pow(x, j) + (j == 0 ? 0 : beta * j * std::pow(x, j - 1) / step_);
  const Vector w = conditions.transpose().partialPivLu().solve(wanted_combination);
  return {w.head(values), with_rate ? w[values] : 0.0};
}

void BdfHistory::begin_step(double time, double step_size, int order) {
  time_ = time;
  step_ = step_size;
  order_ = order;
  c_ = 0;
  for (int j = 1; j <= order; ++j) c_ += 1 / (j * step_size);
  if (order == 1) {  // implicit Euler, whatever the prediction, whose rate at a start nobody has
    g_ = {Vector::Constant(1, c_), 0};
    return;
  }
  g_ = weights(order, time, c_, -1);
}

Vector BdfHistory::apply(const Weights& weights, const Past& past) {
  Vector sum = weights.values[0] * past.values[0];
  for (Eigen::Index i = 1; i < weights.values.size(); ++i)
    sum += weights.values[i] * past.values[static_cast<std::size_t>(i)];
  if (weights.rate != 0) sum += weights.rate * past.rate;
  return sum;
}

Vector BdfHistory::g(const Past& past) const { return apply(g_, past); }

Vector BdfHistory::predicted(const Past& past) const { return apply(weights(order_, time_, 1, 0), past); }

void BdfHistory::accept(const Vector& y, const Vector& g, Past& past) const {
  past.rate = c_ * y - g;
  past.values.push_front(y);
  if (past.values.size() > static_cast<std::size_t>(max_order_) + 1) past.values.pop_back();
}

void BdfHistory::end_step() {
  times_.push_front(time_);
  if (times_.size() > static_cast<std::size_t>(max_order_) + 1) times_.pop_back();
}

Vector BdfHistory::at(double time, const Past& past) const {
  if (time == times_.front()) return past.values.front();
  return apply(weights(order_, time, 1, 0), past);
}

}  // namespace sundrape

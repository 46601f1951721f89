#include "sundrape/integrate/forward_sensitivity.hpp"

#include <fmt/format.h>

namespace sundrape {
namespace {

// Of the derivatives' linear systems, on what the prediction leaves: what is not solved for adds up like errors of
// steps. A residual hardly sees slow motions next to the membrane, so it has to be small (docs/sensitivities.md).
constexpr double tolerance = 1e-5;
// Largest change of a rate that C is differenced by [m/s]: far below the speed at which friction sets in.
constexpr double rate_change = 1e-8;

}  // namespace

ForwardSensitivity::ForwardSensitivity(const System& system, std::unique_ptr<LinearSolver> solver,
                                       std::vector<ParameterDerivative*> parameters, BdfForm form, int max_order)
    : system_(system),
      condensed_(system, std::move(solver), tolerance),
      forces_(system),
      parameters_(std::move(parameters)),
      history_(form, max_order),
      past_(parameters_.size()) {
  for (auto* rows : {&rows_q_, &rows_v_, &acceleration_, &product_rows_}) rows->setZero(system.unknowns().size());
  for (auto* all : {&shifted_, &product_, &supports_q_, &supports_v_}) all->setZero(3 * system.mass().size());
}

void ForwardSensitivity::set(const std::vector<Vector>& q, const std::vector<Vector>& v) {
  const auto n = system_.unknowns().size();
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    Vector y(2 * n);
    system_.unknowns().gather(q.at(k), y.head(n));
    system_.unknowns().gather(v.at(k), y.tail(n));
    past_[k].values.assign(1, y);
  }
}

void ForwardSensitivity::restart(double time) {
  history_.restart(time);
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    auto& past = past_[k];
    past.values.resize(1);
    past.rate = Vector::Zero(past.values.front().size());
    follow_supports(time, k, past.values.front());
  }
}

void ForwardSensitivity::follow_supports(double time, std::size_t parameter, Vector& y) const {
  const auto& unknowns = system_.unknowns();
  if (unknowns.held_components().empty()) return;
  parameters_[parameter]->supports(time, 0, supports_q_, supports_v_);
  for (const auto& [row, component] : unknowns.held_components()) {
    const auto entry = 3 * unknowns.point_of_row()[static_cast<std::size_t>(row)] + component;
    y[3 * row + component] = supports_q_[entry];
    y[unknowns.size() + 3 * row + component] = supports_v_[entry];
  }
}

void ForwardSensitivity::add_damping_product(const State& all, ConstVectorRef rates, VectorRef right_side) {
  const auto& unknowns = system_.unknowns();
  free_rates_ = rates;
  unknowns.clear_held(free_rates_);  // what supports do is in the derivative by the parameter
  const double largest = free_rates_.lpNorm<Eigen::Infinity>();
  if (largest == 0) return;
  const double change = rate_change / largest;
  shifted_.setZero();
  unknowns.scatter(free_rates_, shifted_);
  shifted_ = all.v + change * shifted_;
  system_.force({all.time, all.q, shifted_}, product_);
  product_ = (forces_.sum() - product_) / change;
  for (int r = 0; r < unknowns.rows(); ++r)
    point(right_side, r) += point(product_, unknowns.point_of_row()[static_cast<std::size_t>(r)]);
}

void ForwardSensitivity::step(const StepReport& report, const State& all) {
  const auto& unknowns = system_.unknowns();
  const auto n = unknowns.size();
  const auto& mass = system_.row_mass();
  history_.begin_step(report.time, report.step_size, report.order);
  const double c = history_.c();
  unknowns.gather(all.q, rows_q_);
  unknowns.gather(all.v, rows_v_);
  const auto fail = [&](const std::string& why) {
    throw IntegrationFailure(fmt::format("the sensitivities cannot be computed at t = {:.6g} s: {}", report.time, why));
  };
  if (condensed_.prepare(report.time, c, rows_q_, rows_v_) != FactorStatus::ok) fail("the matrix is singular");
  forces_.evaluate(all);
  unknowns.gather(forces_.sum(), acceleration_);
  for (int r = 0; r < unknowns.rows(); ++r) point(acceleration_, r) *= mass[r] > 0 ? 1 / mass[r] : 0.0;
  const auto count = static_cast<Eigen::Index>(parameters_.size());
  right_sides_.resize(n, count);
  std::vector<Vector> g, y;
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    auto right_side = right_sides_.col(static_cast<Eigen::Index>(k));
    g.push_back(history_.g(past_[k]));
    y.push_back(history_.predicted(past_[k]));
    parameters_[k]->force(forces_, right_side);
    const auto& mass_change = parameters_[k]->row_mass();
    for (int r = 0; r < unknowns.rows(); ++r)
      right_side.segment<3>(3 * r) += mass[r] * (g[k].segment<3>(n + 3 * r) + c * g[k].segment<3>(3 * r)) -
                                      mass_change[r] * point(acceleration_, r);
    add_damping_product(all, g[k].head(n), right_side);
    unknowns.clear_held(right_side);
    // the prediction is good to some digits, which then need not be solved for
    condensed_.matrix().multiply(y[k].head(n), product_rows_);
    right_side -= product_rows_;
    unknowns.clear_held(right_side);
  }
  const auto solved = condensed_.solver().solve_all(right_sides_, s_, tolerance);
  linear_iterations_ += solved.iterations;
  if (!solved.ok || !s_.allFinite()) fail(solved.problem);
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    y[k].head(n) += s_.col(static_cast<Eigen::Index>(k));
    y[k].tail(n) = c * y[k].head(n) - g[k].head(n);
    follow_supports(report.time, k, y[k]);
    history_.accept(y[k], g[k], past_[k]);
  }
  history_.end_step();
}

void ForwardSensitivity::at(double time, std::size_t parameter, VectorRef s, VectorRef s_dot) const {
  const auto n = system_.unknowns().size();
  parameters_[parameter]->supports(time, 0, supports_q_, supports_v_);
  s = supports_q_;
  s_dot = supports_v_;
  Vector y = history_.at(time, past_[parameter]);
  follow_supports(time, parameter, y);
  system_.unknowns().scatter(y.head(n), s);
  system_.unknowns().scatter(y.tail(n), s_dot);
}

}  // namespace sundrape

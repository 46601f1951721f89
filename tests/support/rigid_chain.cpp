#include "support/rigid_chain.hpp"

#include <cmath>
#include <stdexcept>

namespace sundrape {
namespace {

/// Solves the symmetric tridiagonal system (Thomas) in place: `right_side` becomes the solution.
void solve(std::vector<double> diagonal, const std::vector<double>& beside, std::vector<double>& right_side) {
  const auto n = diagonal.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = beside[i - 1] / diagonal[i - 1];
    diagonal[i] -= factor * beside[i - 1];
    right_side[i] -= factor * right_side[i - 1];
  }
  right_side[n - 1] /= diagonal[n - 1];
  for (auto i = n - 1; i-- > 0;) right_side[i] = (right_side[i] - beside[i] * right_side[i + 1]) / diagonal[i];
}

/// Moves the links to the equilibrium next to where they are.
void relax(const RigidChain& chain, double weight, std::vector<double>& angle) {
  const auto n = angle.size();
  const double b = chain.length / static_cast<double>(n);
  for (int iteration = 0; iteration < 100; ++iteration) {
    std::vector<double> out_of_balance(n), diagonal(n), beside(n - 1);
    for (std::size_t i = 0; i < n; ++i) {  // hinge i is before link i
      const double arm = i == 0 ? 0.5 * b : b, curvature = (angle[i] - (i == 0 ? 0 : angle[i - 1])) / arm;
      const double moment = std::copysign(chain.moment(std::abs(curvature)), curvature);
      const double stiffness = chain.slope(std::abs(curvature)) / arm;
      const double torque = weight * b * (chain.length - (static_cast<double>(i) + 0.5) * b);
      out_of_balance[i] -= moment + torque * std::cos(angle[i]);
      diagonal[i] += stiffness - torque * std::sin(angle[i]);
      if (i == 0) continue;
      out_of_balance[i - 1] += moment;
      diagonal[i - 1] += stiffness;
      beside[i - 1] = -stiffness;
    }
    solve(std::move(diagonal), beside, out_of_balance);
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      angle[i] += out_of_balance[i];
      largest = std::max(largest, std::abs(out_of_balance[i]));
    }
    if (largest < 1e-11) return;
  }
  throw std::runtime_error("no equilibrium of the chain next to the last one");
}

}  // namespace

Eigen::Vector2d RigidChain::tip(int links) const {
  constexpr int load_steps = 20;
  std::vector<double> angle(static_cast<std::size_t>(links), 0.0);
  for (int load = 1; load <= load_steps; ++load) relax(*this, weight * load / load_steps, angle);
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  for (const double a : angle) tip += length / links * Eigen::Vector2d(std::cos(a), std::sin(a));
  return tip;
}

}  // namespace sundrape

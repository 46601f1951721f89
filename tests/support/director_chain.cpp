#include "support/director_chain.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

#include "sundrape/types.hpp"

namespace sundrape {
namespace {

/// ∂W/∂θ and ∂²W/∂θ² of one edge by the angles at its ends.
struct Edge {
  Eigen::Vector2d gradient;
  Eigen::Matrix2d hessian;
};

Edge edge(const DirectorChain& chain, double a, double lift, double before, double after) {
  const double turn = after - before;
  const double curvature = chain.chord ? 2 * std::sin(turn / 2) / a : turn / a;
  const double by_turn = chain.chord ? std::cos(turn / 2) / a : 1 / a;  // dK/d(turn)
  const double by_turn2 = chain.chord ? -std::sin(turn / 2) / (2 * a) : 0;
  const auto f = chain.law.at(curvature);
  const double first = a * f.moment * by_turn, second = a * (f.slope * by_turn * by_turn + f.moment * by_turn2);
  const double slope = 0.5 * (before + after), c = 0.5 * lift * std::cos(slope), s = 0.25 * lift * std::sin(slope);
  Edge e;
  e.gradient << c - first, c + first;
  e.hessian << second - s, -second - s, -second - s, second - s;
  return e;
}

}  // namespace

DirectorChain::Shape DirectorChain::solve(int elements) const {
  constexpr int load_steps = 40, most_iterations = 100;
  const double a = length / elements;
  Vector angle = Vector::Zero(elements + 1);
  const auto slope = [&](int k) { return 0.5 * (angle[k - 1] + angle[k]); };
  for (int load = 1; load <= load_steps; ++load) {
    const double share = static_cast<double>(load) / load_steps;
    for (int iteration = 0;; ++iteration) {
      if (iteration == most_iterations) throw std::runtime_error("no equilibrium of the chain next to the last one");
      Vector gradient = Vector::Zero(elements + 1);
      Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(elements + 1, elements + 1);
      for (int k = 1; k <= elements; ++k) {
        const double lift = share * a * (weight * (length - (k - 0.5) * a) - tip_force);
        const Edge e = edge(*this, a, lift, angle[k - 1], angle[k]);
        gradient.segment<2>(k - 1) += e.gradient;
        hessian.block<2, 2>(k - 1, k - 1) += e.hessian;
      }
      gradient[elements] -= share * tip_moment;
      const Vector move =
          hessian.bottomRightCorner(elements, elements).partialPivLu().solve(gradient.tail(elements)).eval();
      angle.tail(elements) -= move;
      if (move.cwiseAbs().maxCoeff() < 1e-11) break;
    }
  }
  Shape shape{Eigen::Vector2d::Zero(), angle[elements]};
  for (int k = 1; k <= elements; ++k) shape.tip += a * Eigen::Vector2d(std::cos(slope(k)), std::sin(slope(k)));
  return shape;
}

}  // namespace sundrape

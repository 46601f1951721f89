#include "sundrape/statics/stability.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace sundrape {
namespace {

constexpr int most_iterations = 60;
constexpr double accuracy = 1e-4;  // of the wanted eigenvalues, from one iteration to the next

/// The same start in every run: entries uniform in ±1, free components only.
Eigen::MatrixXd start_vectors(const System& system, Eigen::Index count) {
  std::mt19937 bits(1);
  Eigen::MatrixXd x(system.unknowns().size(), count);
  for (auto& entry : x.reshaped())
    entry = 2 * static_cast<double>(bits()) / static_cast<double>(std::mt19937::max()) - 1;
  for (Eigen::Index k = 0; k < count; ++k) system.unknowns().clear_held(x.col(k));
  return x;
}

}  // namespace

std::optional<int> negative_pivots(const System& system, const State& all, double neutral_frequency) {
  Tangent tangent(system, neutral_frequency);
  (void)tangent.factor(all);
  return tangent.negative_pivots();
}

std::vector<Mode> modes_nearest_to_zero(const System& system, Tangent& tangent, int count) {
  const auto free = system.unknowns().size() - static_cast<Eigen::Index>(system.unknowns().held_components().size());
  const Eigen::Index wanted = std::min<Eigen::Index>(count, free), block = std::min<Eigen::Index>(wanted + 4, free);
  Eigen::MatrixXd x = start_vectors(system, block), y(x.rows(), block), image(x.rows(), block);
  Vector values = Vector::Zero(block);
  for (int k = 0; k < most_iterations; ++k) {
    const Eigen::MatrixXd basis =
        Eigen::HouseholderQR<Eigen::MatrixXd>(x).householderQ() * Eigen::MatrixXd::Identity(x.rows(), block);
    for (Eigen::Index c = 0; c < block; ++c) {
      if (const auto report = tangent.solve(basis.col(c), y.col(c)); !report.ok)
        throw std::runtime_error(report.problem);
      system.unknowns().clear_held(y.col(c));
    }
    // Rayleigh–Ritz on the inverse, whose eigenvalues of largest size are wanted
    const Eigen::MatrixXd projected = basis.transpose() * y;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(0.5 * (projected + projected.transpose()));
    std::vector<Eigen::Index> order(static_cast<std::size_t>(block));
    for (Eigen::Index c = 0; c < block; ++c) order[static_cast<std::size_t>(c)] = c;
    std::ranges::sort(order, std::ranges::greater(), [&](Eigen::Index c) { return std::abs(ritz.eigenvalues()[c]); });
    Vector now(block);
    for (Eigen::Index c = 0; c < block; ++c) {
      const auto from = order[static_cast<std::size_t>(c)];
      now[c] = 1 / ritz.eigenvalues()[from];
      x.col(c) = y * ritz.eigenvectors().col(from);
      image.col(c) = basis * ritz.eigenvectors().col(from);
    }
    const bool settled =
        (now.head(wanted) - values.head(wanted)).cwiseAbs().cwiseQuotient(now.head(wanted).cwiseAbs()).maxCoeff() <
        accuracy;
    values = now;
    if (settled) break;
  }
  std::vector<Mode> modes;
  for (Eigen::Index c = 0; c < wanted; ++c) modes.push_back({values[c], image.col(c).normalized()});
  return modes;
}

std::optional<Mode> unstable_mode(const System& system, Tangent& tangent) {
  const int negative = tangent.negative_pivots().value_or(0);
  if (negative == 0) return std::nullopt;
  const auto modes = modes_nearest_to_zero(system, tangent, std::min(negative + 4, 12));
  const auto lowest = std::ranges::min_element(modes, {}, &Mode::eigenvalue);
  if (lowest == modes.end() || lowest->eigenvalue >= 0) return std::nullopt;
  return *lowest;
}

}  // namespace sundrape

#include "pinned_arch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Dense>

namespace sundrape {
namespace {

using Four = Eigen::Vector4d;  // θ, M, x, z
using Three = Eigen::Vector3d;

Four slope(const PinnedArch& arch, const Three& unknown, const Four& y) {
  const double h = unknown[1], v = unknown[2], c = std::cos(y[0]), s = std::sin(y[0]);
  const double stretch = 1 - (h * c + v * s) / arch.stretching;
  return {-1 / arch.radius + y[1] / arch.bending, stretch * (v * c - h * s), stretch * c, stretch * s};
}

/// What is wrong at the crown, by the classical Runge–Kutta method: slope, place, height.
Three miss(const PinnedArch& arch, const Three& unknown, double height, int steps) {
  Four y{unknown[0], 0, 0, 0};
  const double h = arch.radius * arch.half_angle / steps;
  for (int k = 0; k < steps; ++k) {
    const Four k1 = slope(arch, unknown, y), k2 = slope(arch, unknown, y + 0.5 * h * k1),
               k3 = slope(arch, unknown, y + 0.5 * h * k2), k4 = slope(arch, unknown, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return {y[0], y[2] - arch.radius * std::sin(arch.half_angle), y[3] - height};
}

}  // namespace

double PinnedArch::rise() const { return radius * (1 - std::cos(half_angle)); }

std::vector<double> PinnedArch::forces(const std::vector<double>& heights, int steps) const {
  const double force = bending / (radius * radius);
  const Three scale{half_angle, force / (half_angle * half_angle), force / half_angle};
  Three unknown{half_angle, 0, 0};
  std::vector<double> found;
  for (const double height : heights) {
    for (int iteration = 0;; ++iteration) {
      const Three wrong = miss(*this, unknown, height, steps);
      if (wrong.norm() < 1e-11 * half_angle) break;
      if (iteration == 30 || !wrong.allFinite()) throw std::runtime_error("the arch's equilibrium was not found");
      Eigen::Matrix3d jacobian;
      for (int j = 0; j < 3; ++j) {
        Three up = unknown, down = unknown;
        up[j] += 1e-5 * scale[j];
        down[j] -= 1e-5 * scale[j];
        jacobian.col(j) = (miss(*this, up, height, steps) - miss(*this, down, height, steps)) / (2e-5 * scale[j]);
      }
      unknown -= jacobian.partialPivLu().solve(wrong);
    }
    found.push_back(2 * unknown[2]);
  }
  return found;
}

std::pair<double, double> PinnedArch::limits() const {
  std::vector<double> heights;
  for (int k = 0; k <= 400; ++k) heights.push_back(rise() * (1 - 2.0 * k / 400));
  const auto all = forces(heights, 100);
  const auto largest = std::ranges::max_element(all.begin(), all.begin() + 250);
  return {*largest, *std::min_element(largest, all.end())};
}

}  // namespace sundrape

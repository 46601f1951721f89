#include "sundrape/force/wind_field.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace sundrape {

Vector3 WindField::at(double time) const {
  if (gust.isZero()) return velocity;
  std::mt19937 random(seed);
  double sum = 0;
  for (const double rate : {1.0, std::numbers::sqrt3, std::sqrt(7.0)}) {
    // the engine's own numbers are the same everywhere, those of distributions are not
    const double phase = 2 * std::numbers::pi * static_cast<double>(random()) / 4294967296.0;
    sum += std::sin(2 * std::numbers::pi * rate * time / period + phase) / 3;
  }
  return velocity + sum * gust;
}

}  // namespace sundrape

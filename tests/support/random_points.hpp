#pragma once
#include <random>

#include "sundrape/types.hpp"

namespace sundrape::samples {

/// Points and directions that are the same in every run.
class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : bits_(seed) {}
  /// Uniform in a cube about the origin.
  Vector3 in_cube(double half) { return half * Vector3(uniform(), uniform(), uniform()); }
  Vector3 direction() { return Vector3(normal_(bits_), normal_(bits_), normal_(bits_)).normalized(); }

 private:
  double uniform() { return uniform_(bits_); }
  std::mt19937_64 bits_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
  std::normal_distribution<double> normal_;
};

}  // namespace sundrape::samples

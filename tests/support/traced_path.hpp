#pragma once
#include "sundrape/statics/equilibrium_path.hpp"

#include "support/benchmarks.hpp"

namespace sundrape {

/// An arc-length case followed to its end, with all that its observer was told.
struct TracedPath {
  struct Step {
    int stage;
    double load_factor;
    Vector q;  // all points, 3P [m]
    PathStep report;
  };
  struct Iteration {
    long step;  // that it was for, from 1 on
    double load_factor, residual;
  };
  PathResult result;
  std::vector<Step> steps;
  std::vector<Iteration> iterations;
  std::vector<CriticalPoint> critical;
  std::vector<std::string> remarks, warnings;
};
[[nodiscard]] TracedPath trace(const Benchmark& b);

}  // namespace sundrape

#pragma once
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// How much of a load acts, as a share of its full size.
///
/// Over time it rises smoothly (C²) to its last share and stays. In staged statics (State::stage > 0) it changes in
/// proportion to the load factor, from its share at the end of one stage to that at the end of the next.
struct LoadCourse {
  double rise = 0;                // [s]; 0: there from the start
  std::vector<double> stages{1};  // shares at the ends of the stages; after those listed it stays as it is

  [[nodiscard]] double share(const State& state) const;
  /// Share that the potential of a load of constant direction goes by: over time the last one, since what a rise keeps
  /// back is work that comes from outside.
  [[nodiscard]] double share_of_potential(const State& state) const;
  [[nodiscard]] double last() const { return stages.back(); }
};

}  // namespace sundrape

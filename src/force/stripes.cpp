#include "sundrape/force/stripes.hpp"

#include <algorithm>

namespace sundrape {
namespace {

constexpr std::size_t smallest_stripe = 256;  // elements; below that a thread's start costs more than it saves
constexpr std::size_t most_stripes = 32;

std::vector<std::size_t> equal_cuts(std::size_t elements, std::size_t stripes) {
  std::vector<std::size_t> bounds(stripes + 1);
  for (std::size_t s = 0; s <= stripes; ++s) bounds[s] = elements * s / stripes;
  return bounds;
}

bool same_colour_stripes_are_disjoint(std::span<const std::pair<int, int>> reach,
                                      const std::vector<std::size_t>& bounds) {
  for (std::size_t s = 0; s + 3 < bounds.size(); ++s) {
    int highest = -1;
    for (std::size_t e = bounds[s]; e < bounds[s + 1]; ++e) highest = std::max(highest, reach[e].second);
    if (highest >= reach[bounds[s + 2]].first) return false;
  }
  return true;
}

}  // namespace

Stripes::Stripes(std::span<const std::pair<int, int>> reach) {
  if (reach.empty()) return;
  for (auto stripes = std::clamp<std::size_t>(reach.size() / smallest_stripe, 1, most_stripes);; --stripes) {
    bounds_ = equal_cuts(reach.size(), stripes);
    if (stripes == 1 || same_colour_stripes_are_disjoint(reach, bounds_)) return;
  }
}

}  // namespace sundrape

#include "sundrape/app/drapes.hpp"

#include <algorithm>
#include <tuple>

namespace sundrape {
namespace {

/// Which drape each state belongs to, numbered by its first member.
std::vector<std::size_t> linked(const Eigen::MatrixXd& distances, double threshold) {
  const auto n = static_cast<std::size_t>(distances.rows());
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(n, none), reached;
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (first[seed] != none) continue;
    first[seed] = seed;
    reached = {seed};
    while (!reached.empty()) {
      const auto from = static_cast<Eigen::Index>(reached.back());
      reached.pop_back();
      for (std::size_t to = 0; to < n; ++to)
        if (first[to] == none && distances(from, static_cast<Eigen::Index>(to)) < threshold) {
          first[to] = seed;
          reached.push_back(to);
        }
    }
  }
  return first;
}

}  // namespace

std::vector<Drape> sort_into_drapes(const Eigen::MatrixXd& distances, const std::vector<double>& energies,
                                    double threshold) {
  const auto first = linked(distances, threshold);
  std::vector<Drape> drapes;
  for (std::size_t seed = 0; seed < first.size(); ++seed) {
    if (first[seed] != seed) continue;
    Drape drape;
    for (std::size_t i = seed; i < first.size(); ++i)
      if (first[i] == seed) drape.members.push_back(i);
    drape.representative =
        *std::ranges::min_element(drape.members, {}, [&](std::size_t i) { return std::pair(energies[i], i); });
    for (const auto i : drape.members)
      drape.spread = std::max(drape.spread,
                              distances(static_cast<Eigen::Index>(drape.representative), static_cast<Eigen::Index>(i)));
    drapes.push_back(std::move(drape));
  }
  std::ranges::sort(drapes, {}, [&](const Drape& d) {
    return std::tuple(-static_cast<std::ptrdiff_t>(d.members.size()), energies[d.representative], d.members.front());
  });
  return drapes;
}

}  // namespace sundrape

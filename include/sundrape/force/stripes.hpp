#pragma once
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <omp.h>

namespace sundrape {

/// Cuts a list of elements into stripes such that stripes of the same colour share no point, so that threads can add
/// forces and tangents without locks. Two colours are enough because elements come sorted by their lowest point and
/// reach only a few rows of the mesh further.
///
/// The cut depends on the elements alone, never on the number of threads: sums are bit-identical for any number.
class Stripes {
 public:
  Stripes() = default;
  /// @param reach  lowest and highest point of each element, ascending in the lowest: see sort_into_stripes
  explicit Stripes(std::span<const std::pair<int, int>> reach);

  /// Calls body(begin, end) for every stripe; stripes of one colour may run at the same time.
  template <class Body>
  void for_each(const Body& body) const {
    const auto stripes = static_cast<int>(bounds_.size()) - 1;
    // the same order for one thread: points that two stripes share then gather their parts in the same order
    for (int colour = 0; colour < 2; ++colour) {
#pragma omp parallel for schedule(static) if (stripes > 1 && omp_get_max_threads() > 1)
      for (int s = colour; s < stripes; s += 2)
        body(bounds_[static_cast<std::size_t>(s)], bounds_[static_cast<std::size_t>(s) + 1]);
    }
  }

  /// Σ over elements of summand(begin, end), added up in the same order for any number of threads.
  template <class Summand>
  double sum(const Summand& summand) const {
    const auto stripes = static_cast<int>(bounds_.size()) - 1;
    double total = 0;
    if (stripes < 1) return total;
    std::vector<double> parts(static_cast<std::size_t>(stripes));
#pragma omp parallel for schedule(static) if (stripes > 1 && omp_get_max_threads() > 1)
    for (int s = 0; s < stripes; ++s) {
      const auto i = static_cast<std::size_t>(s);
      parts[i] = summand(bounds_[i], bounds_[i + 1]);
    }
    return std::accumulate(parts.begin(), parts.end(), total);
  }

 private:
  std::vector<std::size_t> bounds_;  // stripe s is [bounds_[s], bounds_[s + 1])
};

/// Sorts elements by the lowest and then the highest point that they reach, and cuts them into stripes.
/// @param points_of  the points of an element, as a range
template <class Element, class PointsOf>
Stripes sort_into_stripes(std::vector<Element>& elements, const PointsOf& points_of) {
  const auto reach = [&](const Element& e) {
    const auto [lowest, highest] = std::ranges::minmax(points_of(e));
    return std::pair<int, int>(lowest, highest);
  };
  std::ranges::sort(elements, {}, reach);
  std::vector<std::pair<int, int>> reaches;
  reaches.reserve(elements.size());
  for (const auto& e : elements) reaches.push_back(reach(e));
  return Stripes(reaches);
}

}  // namespace sundrape

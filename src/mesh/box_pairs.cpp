#include "sundrape/mesh/box_pairs.hpp"

#include <algorithm>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

namespace sundrape {

std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Eigen::AlignedBox3d> boxes) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  constexpr std::ptrdiff_t swept_below = 200;  // boxes; measured, but anything from 10 to 1000 will do
  std::vector<Box> sorted;
  sorted.reserve(boxes.size());
  for (int i = 0; const auto& box : boxes)
    sorted.emplace_back(
        CGAL::Bbox_3(box.min().x(), box.min().y(), box.min().z(), box.max().x(), box.max().y(), box.max().z()), i++);
  std::vector<std::pair<int, int>> pairs;
  const auto found = [&](const Box& a, const Box& b) { pairs.emplace_back(std::minmax({a.info(), b.info()})); };
  CGAL::box_self_intersection_d(sorted.begin(), sorted.end(), found, CGAL::Box_intersection_d::Box_traits_d<Box>(),
                                swept_below);
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace sundrape

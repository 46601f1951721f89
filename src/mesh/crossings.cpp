#include "sundrape/mesh/crossings.hpp"

#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include "sundrape/mesh/box_pairs.hpp"

namespace sundrape {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool share_a_node(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::ranges::any_of(a, [&](int n) { return std::ranges::find(b, n) != b.end(); });
}

}  // namespace

std::vector<std::pair<int, int>> crossings(const SheetSurface& surface, ConstVectorRef q) {
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<int> triangle_of_box;
  for (int t = 0; const auto& triangle : surface.triangles) {
    Eigen::AlignedBox3d box;
    bool finite = true;
    for (const int n : triangle) {
      const Vector3 x = point(q, n);
      finite = finite && x.allFinite();
      box.extend(x);
    }
    if (finite) {
      boxes.push_back(box);
      triangle_of_box.push_back(t);
    }
    ++t;
  }
  const auto corner = [&](int n) {
    const Vector3 x = point(q, n);
    return Kernel::Point_3(x.x(), x.y(), x.z());
  };
  const auto exact = [&](const std::array<int, 3>& t) {
    return Kernel::Triangle_3(corner(t[0]), corner(t[1]), corner(t[2]));
  };
  const auto flat = [&](const Kernel::Triangle_3& t) { return t.is_degenerate(); };
  std::vector<std::pair<int, int>> found;
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    const int s = triangle_of_box[static_cast<std::size_t>(i)], t = triangle_of_box[static_cast<std::size_t>(j)];
    const auto &a = surface.triangles[static_cast<std::size_t>(s)], &b = surface.triangles[static_cast<std::size_t>(t)];
    if (share_a_node(a, b)) continue;
    const auto first = exact(a), second = exact(b);
    if (!flat(first) && !flat(second) && CGAL::do_intersect(first, second)) found.emplace_back(s, t);
  }
  return found;
}

}  // namespace sundrape

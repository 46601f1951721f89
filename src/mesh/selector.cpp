#include "sundrape/mesh/selector.hpp"

#include <algorithm>
#include <ranges>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sundrape {
namespace {

constexpr double coincident = 1e-9;  // of the diagonal: equal but for round-off
constexpr double on_plane = 1e-6;    // of the diagonal

template <class Predicate>
std::vector<int> nodes_where(const std::vector<Vector3>& positions, Predicate&& fits) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (fits(positions[i])) nodes.push_back(static_cast<int>(i));
  return nodes;
}

struct Select {
  const QuadMesh& mesh;
  const std::vector<Vector3>& positions;
  double size;  // diagonal of the mesh [m]

  std::vector<int> operator()(const NamedSet& set) const {
    const auto found = mesh.sets.find(set.name);
    if (found == mesh.sets.end())
      throw std::invalid_argument(fmt::format("the mesh has no node set \"{}\"; it has {}", set.name,
                                              fmt::join(mesh.sets | std::views::keys, ", ")));
    std::vector<int> nodes = found->second;
    std::ranges::sort(nodes);
    return nodes;
  }

  std::vector<int> operator()(const Near& near) const {
    if (positions.empty()) return {};
    const auto distance = [&](const Vector3& x) { return (x - near.point).norm(); };
    const double least = std::ranges::min(positions | std::views::transform(distance));
    return nodes_where(positions, [&](const Vector3& x) { return distance(x) <= least + coincident * size; });
  }

  std::vector<int> operator()(const InBox& box) const {
    const double slack = coincident * size;
    return nodes_where(positions, [&](const Vector3& x) {
      return (x.array() >= box.low.array() - slack).all() && (x.array() <= box.high.array() + slack).all();
    });
  }

  std::vector<int> operator()(const OnPlane& plane) const {
    const double length = plane.normal.norm();
    if (!(length > 0)) throw std::invalid_argument("the normal of a plane must not be zero");
    return nodes_where(positions, [&](const Vector3& x) {
      return std::abs(plane.normal.dot(x - plane.point)) <= on_plane * size * length;
    });
  }

  std::vector<int> operator()(const InSphere& sphere) const {
    return nodes_where(
        positions, [&](const Vector3& x) { return (x - sphere.centre).norm() <= sphere.radius + coincident * size; });
  }
};

}  // namespace

std::vector<int> select(const Selector& selector, const QuadMesh& mesh, const std::vector<Vector3>& positions) {
  return std::visit(Select{mesh, positions, diagonal(mesh)}, selector);
}

}  // namespace sundrape

#include "sundrape/mesh/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace sundrape {
namespace {

using Corners = std::array<Vector3, 3>;

Corners corners_of(const TriangleMesh& mesh, const std::array<int, 3>& triangle) {
  const auto at = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(triangle[k])]; };
  return {at(0), at(1), at(2)};
}

void require_vertices(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw std::invalid_argument("the mesh has no triangles");
  const auto count = static_cast<int>(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= count)
      throw std::invalid_argument(
          fmt::format("triangle {} names vertices {}, {}, {}, but there are {} (counted from 0)", t, a, b, c, count));
    if (a == b || b == c || c == a)
      throw std::invalid_argument(fmt::format("triangle {} names a vertex twice (counted from 0)", t));
  }
  const auto broken = [](const Vector3& x) { return !x.allFinite(); };
  const auto first = std::ranges::find_if(mesh.vertices, broken);
  if (first != mesh.vertices.end())
    throw std::invalid_argument(fmt::format("{} of {} vertices are no finite numbers, vertex {} (counted from 0) first",
                                            std::ranges::count_if(mesh.vertices, broken), count,
                                            first - mesh.vertices.begin()));
}

/// A side of a triangle, from its lower to its higher vertex number, or the other way round.
struct Side {
  int low, high;
  bool forward;

  [[nodiscard]] bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sides_by_edge(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::pair(s.low, s.high); });
  return sides;
}

/// Edges with the same defect, and the middle of one of them.
struct Defect {
  int edges = 0;
  Vector3 example = Vector3::Zero();

  void add(const TriangleMesh& mesh, const Side& side) {
    if (edges++ == 0)
      example = 0.5 * (mesh.vertices[static_cast<std::size_t>(side.low)] +
                       mesh.vertices[static_cast<std::size_t>(side.high)]);
  }
  void refuse(const char* what, const char* one_has, const char* they_have, const char* remedy) const {
    if (edges == 0) return;
    throw std::invalid_argument(fmt::format("{}: {} {}, e.g. at ({:.4g}, {:.4g}, {:.4g}) m; {}", what, edges,
                                            edges == 1 ? one_has : they_have, example.x(), example.y(), example.z(),
                                            remedy));
  }
};

void require_closed_edges(const TriangleMesh& mesh) {
  Defect open, crowded, turned;
  const auto sides = sides_by_edge(mesh);
  for (auto side = sides.begin(); side != sides.end();) {
    const auto end = std::find_if_not(side, sides.end(), [&](const Side& s) { return s.same_edge(*side); });
    const auto triangles = end - side;
    if (triangles == 1) open.add(mesh, *side);
    if (triangles > 2) crowded.add(mesh, *side);
    if (triangles == 2 && side->forward == (side + 1)->forward) turned.add(mesh, *side);
    side = end;
  }
  open.refuse("the mesh is open", "edge has one triangle only", "edges have one triangle only",
              "obstacles must be watertight: close the holes, and merge vertices that all but coincide");
  crowded.refuse("the mesh branches", "edge has more than two triangles", "edges have more than two triangles",
                 "an obstacle's surface must not: remove inner walls and double triangles, and move parts that touch "
                 "along an edge apart or into each other");
  turned.refuse("the triangles do not agree on inside and outside", "edge has neighbours that face opposite ways",
                "edges have neighbours that face opposite ways", "make all normals point outwards");
}

}  // namespace

void check_closed(const TriangleMesh& mesh) {
  require_vertices(mesh);
  require_closed_edges(mesh);
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  // Coordinates in single precision leave a flat sheet with two sides a thickness of 1e-7 of its size.
  if (!(std::abs(volume(mesh)) > 1e-6 * area * bounds(mesh).diagonal().norm()))
    throw std::invalid_argument(fmt::format(
        "the mesh encloses no volume: {:.3g} m³ within a surface of {:.3g} m²; an obstacle must have a thickness",
        volume(mesh), area));
}

Eigen::AlignedBox3d bounds(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& x : mesh.vertices) box.extend(x);
  return box;
}

double volume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  // Seen from within, the tetrahedra are small and little cancels.
  const Vector3 centre = bounds(mesh).center();
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    sum += (a - centre).dot((b - centre).cross(c - centre)) / 6;
  }
  return sum;
}

}  // namespace sundrape

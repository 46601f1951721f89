#include "sundrape/mesh/sheet_surface.hpp"

#include <algorithm>
#include <queue>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "sundrape/mesh/edges.hpp"

namespace sundrape {
namespace {

/// The sides of quads and the diagonals that cut them, by ascending (i, j), with the triangles at them.
std::vector<SheetSurface::Edge> sides_and_diagonals(const QuadMesh& mesh) {
  const auto table = edge_table(mesh);
  std::vector<SheetSurface::Edge> edges;
  edges.reserve(table.edges.size() + mesh.quads.size());
  for (const auto& side : table.edges) edges.push_back({.i = side.i, .j = side.j});
  for (int first = 0; const auto& sides : table.quad_edge) {
    for (std::size_t k = 0; k < 4; ++k) {
      auto& [here, beyond] = edges[static_cast<std::size_t>(sides[k])].triangles;
      (here < 0 ? here : beyond) = k < 2 ? first : first + 1;
    }
    first += 2;
  }
  for (int first = 0; const auto& quad : mesh.quads) {
    const auto [i, j] = std::minmax({quad[0], quad[2]});
    edges.push_back({.i = i, .j = j, .triangles = {first, first + 1}});
    first += 2;
  }
  const auto ends = [](const SheetSurface::Edge& e) { return std::pair(e.i, e.j); };
  std::ranges::sort(edges, {}, ends);
  // a diagonal that is a side, or a diagonal, of another quad as well
  if (const auto twice = std::ranges::adjacent_find(edges, {}, ends); twice != edges.end())
    throw std::invalid_argument(
        fmt::format("more than two quads share the edge between nodes {} and {}", twice->i, twice->j));
  return edges;
}

}  // namespace

SheetSurface::SheetSurface(const QuadMesh& mesh)
    : node_areas(mesh.reference.size(), 0.0),
      node_triangles(mesh.reference.size()),
      on_boundary(mesh.reference.size(), false) {
  triangles.reserve(2 * mesh.quads.size());
  for (const auto& [a, b, c, d] : mesh.quads) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  std::vector<double> thirds;
  thirds.reserve(triangles.size());
  for (int t = 0; const auto& triangle : triangles) {
    const auto x = [&](std::size_t k) { return mesh.reference[static_cast<std::size_t>(triangle[k])]; };
    thirds.push_back((x(1) - x(0)).cross(x(2) - x(0)).norm() / 6);
    for (const int n : triangle) {
      node_areas[static_cast<std::size_t>(n)] += thirds.back();
      node_triangles[static_cast<std::size_t>(n)].push_back(t);
    }
    ++t;
  }
  edges = sides_and_diagonals(mesh);
  for (auto& edge : edges) {
    edge.length =
        (mesh.reference[static_cast<std::size_t>(edge.i)] - mesh.reference[static_cast<std::size_t>(edge.j)]).norm();
    for (const int t : edge.triangles)
      if (t >= 0) edge.area += thirds[static_cast<std::size_t>(t)];
  }
  for (const auto& edge : edges)
    if (edge.boundary())
      for (const int n : {edge.i, edge.j}) on_boundary[static_cast<std::size_t>(n)] = true;
}

std::vector<std::vector<int>> nodes_within(const QuadMesh& mesh, double reach) {
  struct Way {
    int to;
    double length;
  };
  std::vector<std::vector<Way>> ways(mesh.reference.size());
  for (const auto& quad : mesh.quads)
    for (const int i : quad)
      for (const int j : quad) {
        if (i == j) continue;
        const double length =
            (mesh.reference[static_cast<std::size_t>(i)] - mesh.reference[static_cast<std::size_t>(j)]).norm();
        if (length < reach) ways[static_cast<std::size_t>(i)].push_back({j, length});
      }

  std::vector<std::vector<int>> within(ways.size());
  std::vector<double> distance(ways.size(), reach);
  using Reached = std::pair<double, int>;
  for (std::size_t start = 0; start < ways.size(); ++start) {  // Dijkstra's shortest paths, as far as they matter
    if (ways[start].empty()) continue;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    std::vector<int>& found = within[start];
    distance[start] = 0;
    front.emplace(0.0, static_cast<int>(start));
    while (!front.empty()) {
      const auto [length, node] = front.top();
      front.pop();
      if (length > distance[static_cast<std::size_t>(node)]) continue;
      for (const auto& way : ways[static_cast<std::size_t>(node)]) {
        double& best = distance[static_cast<std::size_t>(way.to)];
        if (length + way.length >= best) continue;
        if (best == reach) found.push_back(way.to);
        best = length + way.length;
        front.emplace(best, way.to);
      }
    }
    distance[start] = reach;
    for (const int n : found) distance[static_cast<std::size_t>(n)] = reach;
    std::ranges::sort(found);
  }
  return within;
}

}  // namespace sundrape

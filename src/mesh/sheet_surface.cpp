#include "sundrape/mesh/sheet_surface.hpp"

#include <algorithm>
#include <queue>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace sundrape {
namespace {

/// A side of a triangle, the lower of its nodes first.
struct Side {
  int i, j, triangle;
};

std::vector<Side> sorted_sides(const std::vector<std::array<int, 3>>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; const auto& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [i, j] = std::minmax({triangle[k], triangle[(k + 1) % 3]});
      sides.push_back({i, j, t});
    }
    ++t;
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.i, s.j, s.triangle); });
  return sides;
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
  const auto length_between = [&](int i, int j) {
    return (mesh.reference[static_cast<std::size_t>(i)] - mesh.reference[static_cast<std::size_t>(j)]).norm();
  };
  for (const auto& side : sorted_sides(triangles)) {
    if (edges.empty() || edges.back().i != side.i || edges.back().j != side.j)
      edges.push_back(
          {.i = side.i, .j = side.j, .triangles = {side.triangle, -1}, .length = length_between(side.i, side.j)});
    else if (edges.back().boundary())
      edges.back().triangles[1] = side.triangle;
    else
      throw std::invalid_argument(
          fmt::format("more than two quads share the edge between nodes {} and {}", side.i, side.j));
    edges.back().area += thirds[static_cast<std::size_t>(side.triangle)];
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

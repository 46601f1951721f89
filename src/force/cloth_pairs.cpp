#include "sundrape/force/cloth_pairs.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>

#include "sundrape/mesh/box_pairs.hpp"

namespace sundrape {
namespace {

constexpr double nearly_parallel = 1e-3;  // sin² of the angle between edges, 1.8°

Eigen::AlignedBox3d box_around(const ClothPair& pair, const std::array<Vector3, 4>& x, std::size_t first,
                               std::size_t last) {
  Eigen::AlignedBox3d box;
  for (std::size_t k = first; k < last && pair.points[k] >= 0; ++k) box.extend(x[k]);
  return box;
}

/// Adds a pair unless it is further apart than `reach`.
void add_if_near(const ClothPair& pair, double reach, const ConstVectorRef& q, std::vector<NearPair>& pairs) {
  const auto x = pair.at(q);
  const std::size_t first_shape = pair.shapes == Shapes::edge_edge ? 2 : 1;
  const auto a = box_around(pair, x, 0, first_shape), b = box_around(pair, x, first_shape, 4);
  if (a.squaredExteriorDistance(b) > reach * reach) return;
  const double distance = separation(pair.shapes, x).distance;
  if (distance <= reach) pairs.push_back({pair, distance});
}

}  // namespace

ClothPairs::ClothPairs(const QuadMesh& mesh, double thickness, double excluded)
    : ClothPairs(mesh, std::vector<double>(mesh.reference.size(), thickness), excluded) {}

ClothPairs::ClothPairs(const QuadMesh& mesh, std::vector<double> thickness, double excluded)
    : surface_(mesh),
      quads_(mesh.quads),
      owned_(mesh.quads.size()),
      thickness_(std::move(thickness)),
      largest_(0),
      smallest_(std::numeric_limits<double>::infinity()) {
  if (thickness_.size() != mesh.reference.size()) throw std::invalid_argument("cloth needs one thickness a node");
  for (const double h : thickness_) {
    if (!(h > 0)) throw std::invalid_argument("the thickness of cloth must be positive [m]");
    largest_ = std::max(largest_, h);
    smallest_ = std::min(smallest_, h);
  }
  near_ = nodes_within(mesh, excluded * largest_);
  std::vector<bool> taken(mesh.reference.size(), false);
  for (std::size_t e = 0; e < quads_.size(); ++e)
    for (const int n : quads_[e]) {
      if (taken[static_cast<std::size_t>(n)]) continue;
      taken[static_cast<std::size_t>(n)] = true;
      owned_[e].nodes.push_back(n);
    }
  for (int e = 0; const auto& edge : surface_.edges)
    owned_[static_cast<std::size_t>(edge.triangles[0]) / 2].edges.push_back(e++);
}

bool ClothPairs::apart(int i, int j) const {
  return i != j && !std::ranges::binary_search(near_[static_cast<std::size_t>(i)], j);
}

template <class Nodes>
bool ClothPairs::apart_from(int node, const Nodes& nodes) const {
  return std::ranges::all_of(nodes, [&](int n) { return apart(node, n); });
}

bool ClothPairs::apart_from_triangle(int node, int triangle) const {
  return apart_from(node, surface_.triangles[static_cast<std::size_t>(triangle)]);
}

void ClothPairs::add_from_node(int node, std::size_t quad, double reach, const ConstVectorRef& q,
                               std::vector<NearPair>& pairs) const {
  const double half = 0.5 * surface_.node_areas[static_cast<std::size_t>(node)];
  for (const std::size_t t : {2 * quad, 2 * quad + 1}) {
    const auto& [a, b, c] = surface_.triangles[t];
    if (apart_from_triangle(node, static_cast<int>(t)))
      add_if_near({Shapes::point_triangle, {node, a, b, c}, half, between(node, a)}, reach, q, pairs);
  }
  for (const int e : owned_[quad].edges) {
    const auto& edge = surface_.edges[static_cast<std::size_t>(e)];
    if (!edge.boundary() && std::ranges::all_of(edge.triangles, [&](int t) { return apart_from_triangle(node, t); }))
      add_if_near({Shapes::point_edge, {node, edge.i, edge.j, -1}, -half, between(node, edge.i)}, reach, q, pairs);
  }
  for (const int n : owned_[quad].nodes) {
    const auto& around = surface_.node_triangles[static_cast<std::size_t>(n)];
    if (!surface_.on_boundary[static_cast<std::size_t>(n)] &&
        std::ranges::all_of(around, [&](int t) { return apart_from_triangle(node, t); }))
      add_if_near({Shapes::point_point, {node, n, -1, -1}, half, between(node, n)}, reach, q, pairs);
  }
}

void ClothPairs::add_of_edges(int a, int b, double reach, const ConstVectorRef& q, std::vector<NearPair>& pairs) const {
  const auto &first = surface_.edges[static_cast<std::size_t>(a)],
             &second = surface_.edges[static_cast<std::size_t>(b)];
  const std::array<int, 2> ends{second.i, second.j};
  if (!apart_from(first.i, ends) || !apart_from(first.j, ends)) return;
  const double both = first.length * second.length;
  add_if_near({.shapes = Shapes::edge_edge,
               .points = {first.i, first.j, second.i, second.j},
               .area = 0.25 * (first.area + second.area),
               .thickness = between(first.i, second.i),
               .parallel2 = nearly_parallel * both * both},
              reach, q, pairs);
}

std::vector<NearPair> ClothPairs::within(double reach, ConstVectorRef q) const {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(quads_.size());
  for (const auto& quad : quads_) {
    Eigen::AlignedBox3d box;
    for (const int n : quad) box.extend(Vector3(point(q, n)));
    box.min().array() -= 0.5 * reach;
    box.max().array() += 0.5 * reach;
    boxes.push_back(box);
  }
  std::vector<NearPair> pairs;
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    for (const int n : owned_[a].nodes) add_from_node(n, b, reach, q, pairs);
    for (const int n : owned_[b].nodes) add_from_node(n, a, reach, q, pairs);
    for (const int e : owned_[a].edges)
      for (const int f : owned_[b].edges) add_of_edges(e, f, reach, q, pairs);
  }
  return pairs;
}

}  // namespace sundrape

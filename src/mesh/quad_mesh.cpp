#include "sundrape/mesh/quad_mesh.hpp"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "sundrape/mesh/edges.hpp"

namespace sundrape {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Half the cross product of the diagonals: along the normal, as long as the area.
Vector3 area_vector(const std::array<int, 4>& quad, const std::vector<Vector3>& x) {
  const Vector3 first = x[index(quad[2])] - x[index(quad[0])];
  const Vector3 second = x[index(quad[3])] - x[index(quad[1])];
  return 0.5 * first.cross(second);
}

double edge_length(const Edge& edge, const std::vector<Vector3>& x) {
  return (x[index(edge.j)] - x[index(edge.i)]).norm();
}

void require_finite(const QuadMesh& mesh) {
  if (mesh.material.size() != mesh.reference.size())
    throw std::invalid_argument(
        fmt::format("{} nodes, but {} material coordinates", mesh.nodes(), mesh.material.size()));
  for (std::size_t i = 0; i < mesh.reference.size(); ++i)
    if (!mesh.reference[i].allFinite() || !mesh.material[i].allFinite())
      throw std::invalid_argument(fmt::format("node {} has a coordinate that is not finite", i));
}

void require_proper_quad(const QuadMesh& mesh, std::size_t e) {
  const auto& quad = mesh.quads[e];
  for (std::size_t k = 0; k < 4; ++k) {
    if (quad[k] < 0 || quad[k] >= mesh.nodes())
      throw std::invalid_argument(fmt::format("quad {} names node {}, which does not exist", e, quad[k]));
    if (std::count(quad.begin(), quad.end(), quad[k]) > 1)
      throw std::invalid_argument(fmt::format("quad {} names node {} twice", e, quad[k]));
  }
  double longest = 0;
  for (std::size_t k = 0; k < 4; ++k)
    longest = std::max(longest, (mesh.reference[index(quad[(k + 1) % 4])] - mesh.reference[index(quad[k])]).norm());
  if (!(area_vector(quad, mesh.reference).norm() > 1e-9 * longest * longest))
    throw std::invalid_argument(fmt::format("quad {} has no area", e));
}

/// Two quads that run round in the same sense pass their common edge in opposite directions.
void require_oriented(const QuadMesh& mesh) {
  const auto table = edge_table(mesh);
  const auto runs_from_i = [&](int quad, const Edge& edge) {
    const auto& q = mesh.quads[index(quad)];
    for (std::size_t k = 0; k < 4; ++k)
      if (q[k] == edge.i && q[(k + 1) % 4] == edge.j) return true;
    return false;
  };
  for (const auto& edge : table.edges)
    if (!edge.boundary() && runs_from_i(edge.quads[0], edge) == runs_from_i(edge.quads[1], edge))
      throw std::invalid_argument(
          fmt::format("quads {} and {} are neighbours but run round in opposite senses", edge.quads[0], edge.quads[1]));
}

}  // namespace

std::vector<double> quad_areas(const QuadMesh& mesh) {
  std::vector<double> areas;
  areas.reserve(mesh.quads.size());
  for (const auto& quad : mesh.quads) areas.push_back(area_vector(quad, mesh.reference).norm());
  return areas;
}

std::vector<double> tributary_areas(const QuadMesh& mesh) {
  std::vector<double> areas(mesh.reference.size(), 0.0);
  for (const auto& quad : mesh.quads) {
    const double quarter = 0.25 * area_vector(quad, mesh.reference).norm();
    for (const int i : quad) areas[index(i)] += quarter;
  }
  return areas;
}

std::vector<double> tributary_edge_lengths(const QuadMesh& mesh, const std::vector<int>& nodes) {
  std::vector<char> chosen(mesh.reference.size(), 0);
  for (const int i : nodes) chosen.at(index(i)) = 1;
  std::vector<double> lengths(mesh.reference.size(), 0.0);
  for (const auto& edge : edge_table(mesh).edges) {
    if (!edge.boundary() || !chosen[index(edge.i)] || !chosen[index(edge.j)]) continue;
    const double half = 0.5 * edge_length(edge, mesh.reference);
    lengths[index(edge.i)] += half;
    lengths[index(edge.j)] += half;
  }
  return lengths;
}

double diagonal(const QuadMesh& mesh) {
  if (mesh.reference.empty()) return 0;
  Vector3 low = mesh.reference.front(), high = low;
  for (const auto& x : mesh.reference) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

double mean_edge_length(const QuadMesh& mesh) {
  const auto edges = edge_table(mesh).edges;
  double sum = 0;
  for (const auto& edge : edges) sum += edge_length(edge, mesh.reference);
  return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

std::vector<Vector3> node_normals(const QuadMesh& mesh, const std::vector<Vector3>& positions) {
  std::vector<Vector3> normals(mesh.reference.size(), Vector3::Zero());
  for (const auto& quad : mesh.quads) {
    const Vector3 normal = area_vector(quad, positions);
    for (const int i : quad) normals[index(i)] += normal;
  }
  for (auto& normal : normals) normal.normalize();
  return normals;
}

std::vector<int> boundary_nodes(const QuadMesh& mesh) {
  std::vector<int> nodes;
  for (const auto& edge : edge_table(mesh).edges)
    if (edge.boundary()) nodes.insert(nodes.end(), {edge.i, edge.j});
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void require_sound(const QuadMesh& mesh) {
  require_finite(mesh);
  std::vector<char> used(mesh.reference.size(), 0);
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    require_proper_quad(mesh, e);
    for (const int i : mesh.quads[e]) used[index(i)] = 1;
  }
  const auto unused = std::ranges::find(used, 0);
  if (unused != used.end())
    throw std::invalid_argument(fmt::format("no quad uses node {}", std::distance(used.begin(), unused)));
  require_oriented(mesh);
}

}  // namespace sundrape

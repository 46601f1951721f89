#include "sundrape/mesh/directors.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sundrape/mesh/edges.hpp"

namespace sundrape {

std::vector<Vector3> rest_directors(const QuadMesh& mesh) {
  const auto x = [&](int i) -> const Vector3& { return mesh.reference[static_cast<std::size_t>(i)]; };
  std::vector<Vector3> directors(mesh.reference.size(), Vector3::Zero());
  std::vector<int> quads_at(mesh.reference.size(), 0);
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto node = static_cast<std::size_t>(quad[k]);
      const Vector3 on = x(quad[(k + 1) % 4]) - x(quad[k]), back = x(quad[(k + 3) % 4]) - x(quad[k]);
      directors[node] += on.cross(back) / (on.squaredNorm() * back.squaredNorm());
      ++quads_at[node];
    }
  for (auto& t : directors) t.normalize();

  std::vector<char> on_boundary(mesh.reference.size(), 0);
  for (const int i : boundary_nodes(mesh)) on_boundary[static_cast<std::size_t>(i)] = 1;
  const auto edges = edge_table(mesh).edges;
  /// Nodes for which `wrong` holds take over from neighbours for which `right` does.
  const auto reflect = [&](const auto& wrong, const auto& right) {
    std::vector<Vector3> sums(directors.size(), Vector3::Zero());
    for (const auto& edge : edges)
      for (const auto& [from, to] : {std::pair{edge.i, edge.j}, std::pair{edge.j, edge.i}}) {
        const auto f = static_cast<std::size_t>(from), t = static_cast<std::size_t>(to);
        if (!right(f) || !wrong(t)) continue;
        const Vector3 along = (x(to) - x(from)).normalized();
        sums[t] += directors[f] - 2 * directors[f].dot(along) * along;
      }
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (sums[i].norm() > 0) directors[i] = sums[i].normalized();
  };
  reflect([&](std::size_t i) { return on_boundary[i] && quads_at[i] > 1; },
          [&](std::size_t i) { return !on_boundary[i]; });
  reflect([&](std::size_t i) { return quads_at[i] == 1; }, [&](std::size_t i) { return quads_at[i] > 1; });
  return directors;
}

double sharpest_turn(const QuadMesh& mesh, ConstVectorRef directors) {
  double sharpest = 0;
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3 a = point(directors, quad[k]), b = point(directors, quad[(k + 1) % 4]);
      sharpest = std::max(sharpest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  return sharpest;
}

std::vector<Vector3> carried_directors(const QuadMesh& mesh, const std::vector<Vector3>& directors,
                                       const std::vector<Vector3>& from, const std::vector<Vector3>& to) {
  const auto before = node_normals(mesh, from), after = node_normals(mesh, to);
  std::vector<Vector3> carried;
  carried.reserve(directors.size());
  for (std::size_t i = 0; i < directors.size(); ++i)
    carried.push_back(Eigen::Quaterniond::FromTwoVectors(before[i], after[i]) * directors[i]);
  return carried;
}

}  // namespace sundrape

#include "sundrape/export/vertex_fields.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace sundrape {
namespace {

using Quad = std::array<int, 4>;

/// a·a, a·b and b·b of the directions a from side 3–0 to 1–2 and b from 0–1 to 2–3 of a quad [m²].
struct Dots {
  double aa, ab, bb;
};

/// The vectors of a quad along its two directions, at its centre.
struct Midlines {
  Vector3 a, b;
};

template <class Table>
Midlines midlines(const Quad& quad, const Table& x) {
  const auto at = [&](std::size_t k) -> const Vector3& { return x[static_cast<std::size_t>(quad[k])]; };
  return {0.5 * (at(1) + at(2) - at(0) - at(3)), 0.5 * (at(2) + at(3) - at(0) - at(1))};
}

Dots dots(const Quad& quad, const std::vector<Vector3>& x, StrainOf kind) {
  if (kind == StrainOf::centre) {
    const auto [a, b] = midlines(quad, x);
    return {a.dot(a), a.dot(b), b.dot(b)};
  }
  const auto square = [&](std::size_t i, std::size_t j) {
    return (x[static_cast<std::size_t>(quad[j])] - x[static_cast<std::size_t>(quad[i])]).squaredNorm();
  };
  return {(square(0, 1) + square(3, 2)) / 2, (square(0, 2) - square(1, 3)) / 4, (square(0, 3) + square(1, 2)) / 2};
}

/// Largest principal stretch of a quad less 1, from its metric at rest and now.
double principal_strain(const Dots& rest, const Dots& now) {
  // in a frame at right angles whose first axis is a at rest, b = lean a + height e₂
  const double lean = rest.ab / rest.aa, height_squared = rest.bb - rest.ab * lean;
  const double c11 = now.aa / rest.aa;
  const double c12 = (now.ab - lean * now.aa) / std::sqrt(rest.aa * height_squared);
  const double c22 = (now.bb - 2 * lean * now.ab + lean * lean * now.aa) / height_squared;
  const double largest = (c11 + c22) / 2 + std::hypot((c11 - c22) / 2, c12);
  return std::sqrt(std::max(largest, 0.0)) - 1;
}

/// Columns are vectors of the sheet in a frame of the quad's plane now.
Eigen::Matrix2d in_plane(const Midlines& vectors, const Vector3& e1, const Vector3& e2) {
  Eigen::Matrix2d m;
  m << vectors.a.dot(e1), vectors.b.dot(e1), vectors.a.dot(e2), vectors.b.dot(e2);
  return m;
}

/// Larger size of a quad's principal curvatures [1/m]: (change of the normal) = −S (change of place).
double principal_curvature(const Midlines& place, const Midlines& turn) {
  const Vector3 e1 = place.a.normalized(), e2 = (place.b - place.b.dot(e1) * e1).normalized();
  Eigen::Matrix2d across = in_plane(place, e1, e2);
  if (std::abs(across.determinant()) <= 1e-12 * across.squaredNorm()) across.setIdentity();  // it has collapsed
  const Eigen::Matrix2d shape = -in_plane(turn, e1, e2) * across.inverse();
  return std::abs(shape.trace()) / 2 + std::hypot((shape(0, 0) - shape(1, 1)) / 2, (shape(0, 1) + shape(1, 0)) / 2);
}

/// Means over the quads at each node, weighted by their areas at rest.
template <class OfQuad>
Vector to_nodes(const QuadMesh& mesh, const OfQuad& of_quad) {
  const auto areas = quad_areas(mesh);
  Vector sum = Vector::Zero(mesh.nodes()), weight = Vector::Zero(mesh.nodes());
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    const double value = of_quad(mesh.quads[e]);
    for (const int node : mesh.quads[e]) {
      sum[node] += areas[e] * value;
      weight[node] += areas[e];
    }
  }
  return sum.cwiseQuotient(weight);
}

}  // namespace

Vector principal_strains(const QuadMesh& mesh, const std::vector<Vector3>& positions, StrainOf kind) {
  return to_nodes(mesh, [&](const Quad& quad) {
    return principal_strain(dots(quad, mesh.reference, kind), dots(quad, positions, kind));
  });
}

Vector principal_curvatures(const QuadMesh& mesh, const std::vector<Vector3>& positions,
                            const std::vector<Vector3>& normals) {
  return to_nodes(
      mesh, [&](const Quad& quad) { return principal_curvature(midlines(quad, positions), midlines(quad, normals)); });
}

}  // namespace sundrape

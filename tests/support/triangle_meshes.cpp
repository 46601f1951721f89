#include "triangle_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace sundrape {
namespace {

TriangleMesh icosahedron(double radius) {
  constexpr double g = std::numbers::phi;
  TriangleMesh mesh;
  for (const double one : {-1.0, 1.0})
    for (const double golden : {-g, g})
      for (const Vector3& x : {Vector3(0, one, golden), Vector3(one, golden, 0), Vector3(golden, 0, one)})
        mesh.vertices.emplace_back(radius * x.normalized());
  const double edge = radius * 2 / std::hypot(1, g) * (1 + 1e-9);
  const auto near = [&](int i, int k) {
    return (mesh.vertices[static_cast<std::size_t>(i)] - mesh.vertices[static_cast<std::size_t>(k)]).norm() < edge;
  };
  for (int a = 0; a < 12; ++a)
    for (int b = a + 1; b < 12; ++b)
      for (int c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        const auto& x = mesh.vertices;
        const auto [i, j, k] =
            std::array{static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)};
        const bool outwards = x[i].dot(x[j].cross(x[k])) > 0;
        mesh.triangles.push_back(outwards ? std::array{a, b, c} : std::array{a, c, b});
      }
  return mesh;
}

}  // namespace

TriangleMesh box_mesh(const Vector3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(
        0.5 * size.cwiseProduct(Vector3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1)));
  const std::array<std::array<int, 4>, 6> faces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : faces) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

TriangleMesh ball_mesh(double radius, int halvings) {
  auto mesh = icosahedron(radius);
  for (int pass = 0; pass < halvings; ++pass) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [at, is_new] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.vertices.size()));
      if (is_new) {
        const Vector3 sum = mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)];
        mesh.vertices.emplace_back(radius * sum.normalized());
      }
      return at->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

TriangleMesh torus_mesh(double radius, double section_radius, int around, int across) {
  TriangleMesh mesh;
  const auto vertex = [&](int i, int k) { return (i % around) * across + k % across; };
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < across; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * k / across;
      const double r = radius + section_radius * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), section_radius * std::sin(v));
      mesh.triangles.push_back({vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1)});
      mesh.triangles.push_back({vertex(i, k), vertex(i + 1, k + 1), vertex(i, k + 1)});
    }
  return mesh;
}

TriangleMesh turned_over(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace sundrape

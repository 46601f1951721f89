#include "sundrape/mesh/builders.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace sundrape {
namespace {

int add_node(QuadMesh& mesh, double x, double y) {
  mesh.reference.emplace_back(x, y, 0.0);
  mesh.material.emplace_back(x, y);
  return mesh.nodes() - 1;
}

void add_common_sets(QuadMesh& mesh) {
  auto& all = mesh.sets["all"];
  all.resize(mesh.reference.size());
  std::iota(all.begin(), all.end(), 0);
  mesh.sets["boundary"] = boundary_nodes(mesh);
}

/// Point of the disc's core for (u, v) in [−1, 1]²: a square whose sides bulge towards the circle.
///
/// A mean of the square and of its elliptical image u √(1 − v²/2), v √(1 − u²/2); the bulge of 0.3 and the size of the
/// core were chosen by search for the largest smallest angle and the most even cells.
Eigen::Vector2d core_point(double half_side, double u, double v) {
  constexpr double bulge = 0.3;
  const double stretch_u = 1 - bulge + bulge * std::sqrt(2 - v * v);
  const double stretch_v = 1 - bulge + bulge * std::sqrt(2 - u * u);
  return half_side * Eigen::Vector2d(u * stretch_u, v * stretch_v);
}

/// The border of a grid of (n + 1)² nodes, counter-clockwise from its lower right corner: (ix, iy) of place k < 4 n.
std::pair<int, int> grid_border(int n, int k) {
  const int along = k % n;
  switch (k / n) {
    case 0:
      return {n, along};
    case 1:
      return {n - along, n};
    case 2:
      return {0, n - along};
    default:
      return {along, 0};
  }
}

}  // namespace

QuadMesh rectangle(double length, double width, int cells_warp, int cells_weft) {
  if (!(length > 0 && width > 0)) throw std::invalid_argument("a rectangle's length and width must be positive");
  if (cells_warp < 1 || cells_weft < 1) throw std::invalid_argument("a rectangle needs at least one cell each way");
  QuadMesh mesh;
  const auto node = [&](int ix, int iy) { return iy * (cells_warp + 1) + ix; };
  // symmetric to the last bit: nodes that mirror each other differ in sign only
  const auto place = [](int i, int cells, double size) { return size * (2 * i - cells) / (2.0 * cells); };
  for (int iy = 0; iy <= cells_weft; ++iy)
    for (int ix = 0; ix <= cells_warp; ++ix)
      add_node(mesh, place(ix, cells_warp, length), place(iy, cells_weft, width));
  for (int iy = 0; iy < cells_weft; ++iy)
    for (int ix = 0; ix < cells_warp; ++ix)
      mesh.quads.push_back({node(ix, iy), node(ix + 1, iy), node(ix + 1, iy + 1), node(ix, iy + 1)});

  add_common_sets(mesh);
  for (int iy = 0; iy <= cells_weft; ++iy) {
    mesh.sets["left"].push_back(node(0, iy));
    mesh.sets["right"].push_back(node(cells_warp, iy));
  }
  for (int ix = 0; ix <= cells_warp; ++ix) {
    mesh.sets["bottom"].push_back(node(ix, 0));
    mesh.sets["top"].push_back(node(ix, cells_weft));
  }
  mesh.sets["bottom_left"] = {node(0, 0)};
  mesh.sets["bottom_right"] = {node(cells_warp, 0)};
  mesh.sets["top_left"] = {node(0, cells_weft)};
  mesh.sets["top_right"] = {node(cells_warp, cells_weft)};
  return mesh;
}

QuadMesh disc(double radius, int cells) {
  if (!(radius > 0)) throw std::invalid_argument("a disc's radius must be positive");
  if (cells < 3) throw std::invalid_argument("a disc needs at least three cells across");
  const int rings = std::max(1, (cells + 3) / 6);
  const int n = cells - 2 * rings;  // the core has n × n cells, a ring 4 n
  const double half_side = 0.79 * radius * n / cells;

  QuadMesh mesh;
  const auto core = [&](int ix, int iy) { return iy * (n + 1) + ix; };
  for (int iy = 0; iy <= n; ++iy)
    for (int ix = 0; ix <= n; ++ix) {
      const auto x = core_point(half_side, (2.0 * ix - n) / n, (2.0 * iy - n) / n);
      add_node(mesh, x.x(), x.y());
    }
  for (int iy = 0; iy < n; ++iy)
    for (int ix = 0; ix < n; ++ix)
      mesh.quads.push_back({core(ix, iy), core(ix + 1, iy), core(ix + 1, iy + 1), core(ix, iy + 1)});

  const int around = 4 * n;
  const auto node = [&](int ring, int k) {  // ring 0 is the border of the core
    const auto [ix, iy] = grid_border(n, k % around);
    return ring == 0 ? core(ix, iy) : (n + 1) * (n + 1) + (ring - 1) * around + k % around;
  };
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < around; ++k) {
      const double angle = std::numbers::pi / 4 * (2.0 * k / n - 1);
      const Vector3 inner = mesh.reference[static_cast<std::size_t>(node(0, k))];
      const Vector3 outer(radius * std::cos(angle), radius * std::sin(angle), 0);
      const double outward = static_cast<double>(ring) / rings;
      const Vector3 x = (1 - outward) * inner + outward * outer;
      add_node(mesh, x.x(), x.y());
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < around; ++k)
      mesh.quads.push_back({node(ring, k), node(ring + 1, k), node(ring + 1, k + 1), node(ring, k + 1)});

  add_common_sets(mesh);
  for (int iy = n / 2; iy <= (n + 1) / 2; ++iy)
    for (int ix = n / 2; ix <= (n + 1) / 2; ++ix) mesh.sets["centre"].push_back(core(ix, iy));
  return mesh;
}

QuadMesh annulus(double inner, double outer, int cells_radial, int cells_around) {
  if (!(inner > 0 && outer > inner)) throw std::invalid_argument("an annulus needs 0 < inner radius < outer radius");
  if (cells_radial < 1 || cells_around < 3)
    throw std::invalid_argument("an annulus needs at least one cell across and three around");
  QuadMesh mesh;
  const auto node = [&](int ir, int ia) { return ir * cells_around + ia % cells_around; };
  for (int ir = 0; ir <= cells_radial; ++ir)
    for (int ia = 0; ia < cells_around; ++ia) {
      const double radius = inner + (outer - inner) * ir / cells_radial;
      const double angle = 2 * std::numbers::pi * ia / cells_around;
      add_node(mesh, radius * std::cos(angle), radius * std::sin(angle));
    }
  for (int ir = 0; ir < cells_radial; ++ir)
    for (int ia = 0; ia < cells_around; ++ia)
      mesh.quads.push_back({node(ir, ia), node(ir + 1, ia), node(ir + 1, ia + 1), node(ir, ia + 1)});

  add_common_sets(mesh);
  for (int ia = 0; ia < cells_around; ++ia) {
    mesh.sets["inner"].push_back(node(0, ia));
    mesh.sets["outer"].push_back(node(cells_radial, ia));
  }
  return mesh;
}

}  // namespace sundrape

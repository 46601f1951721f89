#include "sundrape/export/obstacle_surface.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "sundrape/io/file_error.hpp"

namespace sundrape {
namespace {

constexpr int round_facets = 96;    // about a full circle
constexpr int rounding_facets = 8;  // across half of a box's rounded edge

/// Parameters of one obstacle by the names of the case file.
class Parameters {
 public:
  explicit Parameters(const ObstacleRecord& obstacle) : obstacle_(obstacle) {}

  [[nodiscard]] double number(const std::string& name) const { return list(name, 1)[0]; }
  [[nodiscard]] double number(const std::string& name, double otherwise) const {
    return obstacle_.parameters.contains(name) ? number(name) : otherwise;
  }
  [[nodiscard]] Vector3 vector(const std::string& name) const {
    return Eigen::Map<const Vector3>(list(name, 3).data());
  }
  [[nodiscard]] Vector3 vector(const std::string& name, const Vector3& otherwise) const {
    return obstacle_.parameters.contains(name) ? vector(name) : otherwise;
  }

 private:
  [[nodiscard]] const std::vector<double>& list(const std::string& name, std::size_t size) const {
    const auto found = obstacle_.parameters.find(name);
    if (found == obstacle_.parameters.end() || found->second.size() != size)
      throw FileError(fmt::format("obstacle {} of kind {} has no usable \"{}\"", obstacle_.name, obstacle_.kind, name));
    return found->second;
  }

  const ObstacleRecord& obstacle_;
};

/// Two triangles for each cell of a grid of vertices, row by row, from `first` on.
void add_grid(ShadedSurface& surface, int first, int rows, int columns, bool closed) {
  const auto vertex = [&](int row, int column) { return first + row * columns + column % columns; };
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + (closed ? 0 : 1) < columns; ++j) {
      surface.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
      surface.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
    }
}

/// A point of the outline of a body of revolution, with the normal there.
struct OutlinePoint {
  double r, z, normal_r, normal_z;
};
using Outline = std::vector<OutlinePoint>;

/// From `start` to `end`, angles over the horizontal [rad].
Outline arc(double radius, double r, double z, double start, double end) {
  const int facets = static_cast<int>(std::ceil(round_facets * (end - start) / (2 * std::numbers::pi) - 1e-9));
  Outline points;
  for (int k = 0; k <= facets; ++k) {
    const double angle = start + (end - start) * k / facets;
    points.push_back({r + radius * std::cos(angle), z + radius * std::sin(angle), std::cos(angle), std::sin(angle)});
  }
  return points;
}

/// Turns outlines, which run upwards on the outside, about the z axis; each is a smooth part by itself.
ShadedSurface revolved(const std::vector<Outline>& parts) {
  ShadedSurface surface;
  for (const auto& part : parts) {
    const int first = static_cast<int>(surface.vertices.size());
    for (const auto& p : part)
      for (int k = 0; k < round_facets; ++k) {
        const double angle = 2 * std::numbers::pi * k / round_facets, c = std::cos(angle), s = std::sin(angle);
        surface.vertices.emplace_back(p.r * c, p.r * s, p.z);
        surface.normals.emplace_back(p.normal_r * c, p.normal_r * s, p.normal_z);
      }
    add_grid(surface, first, static_cast<int>(part.size()), round_facets, true);
  }
  return surface;
}

constexpr double right_angle = std::numbers::pi / 2;

ShadedSurface sphere(double radius) { return revolved({arc(radius, 0, 0, -right_angle, right_angle)}); }

ShadedSurface capsule(double radius, double length) {
  auto outline = arc(radius, 0, -length / 2, -right_angle, 0);
  const auto top = arc(radius, 0, length / 2, 0, right_angle);
  outline.insert(outline.end(), top.begin(), top.end());
  return revolved({outline});
}

/// A drum from `bottom` to `top`, its edges rounded or sharp.
ShadedSurface drum(double radius, double bottom, double top, double edge) {
  const OutlinePoint low{0, bottom, 0, -1}, high{0, top, 0, 1};
  if (edge <= 0)
    return revolved(
        {{low, {radius, bottom, 0, -1}}, {{radius, bottom, 1, 0}, {radius, top, 1, 0}}, {{radius, top, 0, 1}, high}});
  Outline outline{low};
  const auto lower = arc(edge, radius - edge, bottom + edge, -right_angle, 0);
  const auto upper = arc(edge, radius - edge, top - edge, 0, right_angle);
  outline.insert(outline.end(), lower.begin(), lower.end());
  outline.insert(outline.end(), upper.begin(), upper.end());
  outline.push_back(high);
  return revolved({outline});
}

/// Coordinates of a box's face along one of its directions: dense over the roundings.
std::vector<double> box_lines(double half, double edge) {
  if (edge <= 0) return {-half, half};
  std::vector<double> lines;
  for (int k = rounding_facets; k >= 0; --k)  // even angles on the rounding
    lines.push_back(-half + edge * (1 - std::tan(right_angle / 2 * k / rounding_facets)));
  for (int k = rounding_facets; k >= 0; --k) lines.push_back(-lines[static_cast<std::size_t>(k)]);
  return lines;
}

/// An inner box, smaller by the edge radius, plus a ball: points of the six faces are pulled onto that sum.
ShadedSurface box(const Vector3& size, double edge) {
  const Vector3 half = size / 2, core = (half.array() - edge).max(0).matrix();
  ShadedSurface surface;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto along_u = box_lines(half[u], edge), along_v = box_lines(half[v], edge);
    for (const double side : {-1.0, 1.0}) {
      const int first = static_cast<int>(surface.vertices.size());
      for (const double a : along_u)
        for (const double b : along_v) {
          Vector3 p = Vector3::Zero(), normal = side * Vector3::Unit(axis);
          p[axis] = side * half[axis];
          p[u] = a;
          p[v] = -side * b;  // so that the grid runs counter-clockwise seen from outside
          if (edge > 0) {
            const Vector3 within = p.cwiseMax(-core).cwiseMin(core);
            normal = (p - within).normalized();
            p = within + edge * normal;
          }
          surface.vertices.push_back(p);
          surface.normals.push_back(normal);
        }
      add_grid(surface, first, static_cast<int>(along_u.size()), static_cast<int>(along_v.size()), false);
    }
  }
  return surface;
}

/// A body that the case gives along an axis other than z.
ShadedSurface turned(ShadedSurface surface, const Vector3& axis) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axis);
  for (auto* list : {&surface.vertices, &surface.normals})
    for (auto& v : *list) v = turn * v;
  return surface;
}

ShadedSurface plane(const Vector3& point, const Vector3& direction, const PlanePatch& patch) {
  const Vector3 normal = direction.normalized(), foot = patch.about - normal.dot(patch.about - point) * normal;
  const Vector3 u = normal.unitOrthogonal(), v = normal.cross(u);
  ShadedSurface surface;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    surface.vertices.emplace_back(foot + patch.half * (a * u + b * v));
    surface.normals.push_back(normal);
  }
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  return surface;
}

/// Triangles of a file, shaded flat where they meet at more than 40°, else smoothly: a vertex for each smooth fan.
ShadedSurface faceted(const TriangleMesh& mesh) {
  static const double smooth = std::cos(40 * std::numbers::pi / 180);
  std::vector<Vector3> of_face;
  std::vector<std::vector<std::size_t>> faces_at(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const auto at = [&](int n) -> const Vector3& { return mesh.vertices[static_cast<std::size_t>(n)]; };
    of_face.emplace_back((at(j) - at(i)).cross(at(k) - at(i)));
    for (const int n : mesh.triangles[t]) faces_at[static_cast<std::size_t>(n)].push_back(t);
  }
  ShadedSurface surface;
  std::map<std::pair<int, std::vector<std::size_t>>, int> vertex_of_fan;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<int, 3> corner{};
    for (std::size_t c = 0; c < 3; ++c) {
      const int n = mesh.triangles[t][c];
      std::vector<std::size_t> fan;
      Vector3 normal = Vector3::Zero();
      for (const auto other : faces_at[static_cast<std::size_t>(n)])
        if (of_face[other].normalized().dot(of_face[t].normalized()) >= smooth) {
          fan.push_back(other);
          normal += of_face[other];
        }
      const auto [found, is_new] = vertex_of_fan.try_emplace({n, fan}, static_cast<int>(surface.vertices.size()));
      if (is_new) {
        surface.vertices.push_back(mesh.vertices[static_cast<std::size_t>(n)]);
        surface.normals.push_back(normal.normalized());
      }
      corner[c] = found->second;
    }
    surface.triangles.push_back(corner);
  }
  return surface;
}

}  // namespace

ShadedSurface obstacle_surface(const ObstacleRecord& obstacle, const PlanePatch& patch) {
  const Parameters p(obstacle);
  const Vector3 up = Vector3::UnitZ();
  const auto edge = [&] { return p.number("edge_radius", 0); };
  const std::map<std::string_view, std::function<ShadedSurface()>> shapes{
      {"plane", [&] { return plane(p.vector("point", Vector3::Zero()), p.vector("normal", up), patch); }},
      {"box", [&] { return box(p.vector("size"), edge()); }},
      {"sphere", [&] { return sphere(p.number("radius")); }},
      {"capsule", [&] { return turned(capsule(p.number("radius"), p.number("length")), p.vector("axis", up)); }},
      {"cylinder",
       [&] {
         const double half = p.number("length") / 2;
         return turned(drum(p.number("radius"), -half, half, edge()), p.vector("axis", up));
       }},
      {"disc", [&] { return drum(p.number("radius"), -p.number("height"), 0, edge()); }},
      {"mesh", [&] { return faceted(obstacle.surface); }}};
  const auto found = shapes.find(obstacle.kind);
  if (found == shapes.end())
    throw FileError(fmt::format("obstacle {} is of a kind that cannot be drawn: {}", obstacle.name, obstacle.kind));
  return found->second();
}

}  // namespace sundrape

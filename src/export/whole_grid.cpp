#include "whole_grid.hpp"

#include <limits>

namespace sundrape {
namespace {

template <class Number>
void append(std::vector<Number>& list, const Vector3& v) {
  for (const double component : v) list.push_back(static_cast<Number>(component));
}

}  // namespace

WholeGrid::WholeGrid(const ExportScene& scene) : scene_(scene) {
  offsets.push_back(0);
  const auto add = [&](const auto& faces, int of_part) {
    for (const auto& face : faces) {
      for (const int corner : face) connectivity.push_back(static_cast<std::int64_t>(points) + corner);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
      part.push_back(of_part);
    }
  };
  add(scene.mesh().quads, 0);
  points = scene.mesh().reference.size();
  for (std::size_t b = 0; b < scene.bodies().size(); ++b) {
    add(scene.bodies()[b].surface.triangles, static_cast<int>(b + 1));
    points += scene.bodies()[b].surface.vertices.size();
  }
}

std::vector<double> WholeGrid::positions(const ExportFrame& frame) const {
  std::vector<double> list;
  list.reserve(3 * points);
  for (const auto& p : frame.positions) append(list, p);
  for (std::size_t b = 0; b < frame.bodies.size(); ++b)
    for (const auto& v : scene_.bodies()[b].surface.vertices) append(list, frame.bodies[b](v));
  return list;
}

std::vector<float> WholeGrid::normals(const ExportFrame& frame) const {
  std::vector<float> list;
  list.reserve(3 * points);
  for (const auto& n : frame.normals) append(list, n);
  for (std::size_t b = 0; b < frame.bodies.size(); ++b)
    for (const auto& n : scene_.bodies()[b].surface.normals) append(list, frame.bodies[b].rotation * n);
  return list;
}

std::vector<float> WholeGrid::field(const Vector& of_nodes) const {
  std::vector<float> list;
  list.reserve(points);
  for (const double value : of_nodes) list.push_back(static_cast<float>(value));
  list.resize(points, std::numeric_limits<float>::quiet_NaN());
  return list;
}

std::vector<float> WholeGrid::texture() const {
  std::vector<float> list;
  for (const auto& s : scene_.texture())
    for (const double component : s) list.push_back(static_cast<float>(component));
  list.resize(2 * points, 0);
  return list;
}

}  // namespace sundrape

#include "sundrape/app/last_shape.hpp"

#include <fmt/format.h>

#include "sundrape/io/file_error.hpp"
#include "sundrape/io/mesh_difference.hpp"
#include "sundrape/mesh/directors.hpp"

namespace sundrape {
namespace {

std::vector<Vector3> points_of(const Vector& flat) {
  std::vector<Vector3> points;
  points.reserve(static_cast<std::size_t>(flat.size() / 3));
  for (int i = 0; i < static_cast<int>(flat.size() / 3); ++i) points.emplace_back(point(flat, i));
  return points;
}

}  // namespace

ShapeAtRest last_shape(const ResultReader& result, const QuadMesh& mesh) {
  const auto& name = result.file().name();
  if (const auto difference = mesh_difference(mesh, result.mesh(), but_for_waviness); !difference.empty())
    throw FileError(fmt::format("{}: belongs to another mesh: {}", name, difference));
  if (result.frames() == 0) throw FileError(fmt::format("{}: holds no frame", name));
  const auto last = result.frames() - 1;
  const Vector positions = result.position(last);
  if (!positions.allFinite()) throw FileError(fmt::format("{}: its last positions are not finite", name));
  ShapeAtRest shape{points_of(positions), {}};
  if (result.has_director()) shape.directors = points_of(result.director(last));
  return shape;
}

Vector last_state(const ResultReader& result, const CaseModel& model) {
  auto [positions, directors] = last_shape(result, model.mesh);
  Vector q = model.initial;
  const auto n = positions.size();
  if (model.has_directors() && directors.empty()) {
    std::vector<Vector3> placed;
    placed.reserve(n);
    for (const auto& x : model.mesh.reference) placed.emplace_back(model.placement(x));
    directors = rest_directors(model.mesh);
    for (auto& d : directors) d = model.placement.rotation * d;
    directors = carried_directors(model.mesh, directors, placed, positions);
  }
  for (std::size_t i = 0; i < n; ++i) point(q, static_cast<int>(i)) = positions[i];
  if (model.has_directors())
    for (std::size_t i = 0; i < n; ++i) point(q, static_cast<int>(n + i)) = model.director_length * directors[i];
  return q;
}

}  // namespace sundrape

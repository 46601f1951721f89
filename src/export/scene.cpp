#include "sundrape/export/scene.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "sundrape/export/vertex_fields.hpp"

namespace sundrape {
namespace {

constexpr double frames_a_second = 25;  // of statics, which have no time
constexpr double patch_share = 1.5;     // half the side of a plane's patch, over the diagonal of the cloth's way

std::vector<Vector3> as_points(const Vector& v) {
  std::vector<Vector3> points(static_cast<std::size_t>(v.size() / 3));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = point(v, static_cast<int>(i));
  return points;
}

template <class Points>
auto bounds_of(const Points& points) {
  Eigen::AlignedBox<double, Points::value_type::RowsAtCompileTime> box;
  for (const auto& p : points) box.extend(p);
  return box;
}

}  // namespace

ExportScene::ExportScene(const ResultReader& result, std::vector<std::size_t> frames, bool with_obstacles)
    : result_(result), frames_(std::move(frames)) {
  if (frames_.empty()) throw FileError(fmt::format("{}: holds no frames to export", result.file().name()));
  const auto areas = tributary_areas(mesh());
  areas_ = Eigen::Map<const Vector>(areas.data(), std::ssize(areas));

  const auto extent = bounds_of(mesh().material);
  texture_unit_ = extent.sizes().maxCoeff();
  for (const auto& s : mesh().material) texture_.emplace_back((s - extent.min()) / texture_unit_);

  if (!with_obstacles) return;
  obstacles_ = result.obstacles();
  if (obstacles_.empty()) return;
  Eigen::AlignedBox3d way;
  for (std::size_t k = 0; k < frames_.size(); ++k) way.extend(bounds_of(positions(k)));
  for (const auto& obstacle : obstacles_) {
    const Vector3 about = obstacle.rotation.transpose() * (way.center() - obstacle.position);
    const PlanePatch patch{about, patch_share * way.diagonal().norm()};
    bodies_.push_back({obstacle.name, obstacle_surface(obstacle, patch), obstacle.moves});
  }
}

std::vector<Vector3> ExportScene::positions(std::size_t k) const { return as_points(result_.position(frames_.at(k))); }

ExportFrame ExportScene::frame(std::size_t k) const {
  const auto number = frames_.at(k);
  ExportFrame f{.variable = variable(k), .positions = positions(k), .normals = {}, .fields = {}, .bodies = {}};
  f.normals = node_normals(mesh(), f.positions);
  const auto strain_of = result_.model() == "shell" ? StrainOf::centre : StrainOf::sides_and_diagonals;
  f.fields.push_back({"strain", "1", principal_strains(mesh(), f.positions, strain_of)});
  f.fields.push_back({"curvature", "1/m", principal_curvatures(mesh(), f.positions, f.normals)});
  const Vector force = result_.contact_force(number);
  const Vector sizes = force.reshaped(3, mesh().nodes()).colwise().norm();
  f.fields.push_back({"contact_pressure", "Pa", sizes.cwiseQuotient(areas_)});
  if (result_.has_energy_density()) f.fields.push_back({"energy_density", "J/m^2", result_.energy_density(number)});
  for (std::size_t body = 0; body < bodies_.size(); ++body) f.bodies.push_back(pose(body, number));
  return f;
}

double ExportScene::shown_at(std::size_t k) const {
  if (result_.analysis() == "dynamics") return variable(k) - variable(0);
  return static_cast<double>(k) / frames_a_second;
}

Pose ExportScene::pose(std::size_t body, std::size_t frame) const {
  const auto& start = obstacles_[body];
  if (!start.moves) return {start.position, start.rotation};
  const auto at = result_.obstacle_pose(start.name, frame);
  return {at.position, at.rotation};
}

}  // namespace sundrape

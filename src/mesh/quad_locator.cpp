#include "sundrape/mesh/quad_locator.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace sundrape {
namespace {

using Eigen::Vector2d;

constexpr double outside = 1.0 / 3;  // of a cell that a point may lie off its quad

Eigen::AlignedBox2d box_of(const QuadMesh& mesh, const std::array<int, 4>& quad) {
  Eigen::AlignedBox2d box;
  for (const int node : quad) box.extend(mesh.material[static_cast<std::size_t>(node)]);
  const Vector2d margin = outside * box.sizes();
  return {box.min() - margin, box.max() + margin};
}

double distance_outside(const Vector2d& at) { return (at.array() - 0.5).abs().maxCoeff() - 0.5; }

}  // namespace

QuadLocator::QuadLocator(const QuadMesh& mesh) : mesh_(mesh) {
  Eigen::AlignedBox2d all;
  for (const auto& quad : mesh.quads) all.extend(box_of(mesh, quad));
  const double a_side = std::max(1.0, std::sqrt(static_cast<double>(mesh.quads.size())));
  bins_.setConstant(static_cast<int>(a_side));
  low_ = all.min();
  bin_size_ = all.sizes() / a_side;
  quads_.resize(index(0, bins_.y()));
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const auto box = box_of(mesh, mesh.quads[q]);
    const auto first = bin_of(box.min()), last = bin_of(box.max());
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) quads_[index(x, y)].push_back(static_cast<int>(q));
  }
}

Eigen::Vector2i QuadLocator::bin_of(const Vector2d& point) const {
  const Vector2d bin = ((point - low_).array() / bin_size_.array()).floor();
  const Vector2d last = (bins_.array() - 1).cast<double>();
  return bin.cwiseMax(Vector2d::Zero()).cwiseMin(last).cast<int>();
}

std::optional<QuadLocator::Place> QuadLocator::in_quad(int quad, const Vector2d& point) const {
  const auto& nodes = mesh_.quads[static_cast<std::size_t>(quad)];
  const auto x = [&](std::size_t k) -> const Vector2d& { return mesh_.material[static_cast<std::size_t>(nodes[k])]; };
  const Vector2d along = x(1) - x(0), up = x(3) - x(0), twist = x(2) - x(1) - x(3) + x(0);
  Vector2d at(0.5, 0.5);
  for (int iteration = 0; iteration < 20; ++iteration) {  // Newton on the bilinear map
    const Vector2d off = x(0) + at.x() * along + at.y() * up + at.x() * at.y() * twist - point;
    Eigen::Matrix2d slope;
    slope << along + at.y() * twist, up + at.x() * twist;
    const Vector2d step = slope.inverse() * off;
    if (!step.allFinite()) return {};
    at -= step;
    if (step.cwiseAbs().maxCoeff() < 1e-12) return Place{quad, at};
    if (distance_outside(at) > 2) return {};
  }
  return {};
}

std::optional<QuadLocator::Place> QuadLocator::find(const Vector2d& point) const {
  const auto bin = bin_of(point);
  std::optional<Place> best;
  for (const int quad : quads_[index(bin.x(), bin.y())]) {
    const auto place = in_quad(quad, point);
    if (place && distance_outside(place->at) <= (best ? distance_outside(best->at) : outside)) best = place;
  }
  return best;
}

}  // namespace sundrape

#include "point_lookup.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace sundrape {

PointLookup::PointLookup(std::span<const Vector3> points, double tolerance)
    : points_(points.begin(), points.end()), tolerance_(tolerance) {
  Eigen::AlignedBox3d bounds;
  for (const auto& x : points_) bounds.extend(x);
  // About one point a box of a flat sheet; never so small that a place's neighbours lie two boxes off.
  const double spacing =
      bounds.isEmpty() ? 1.0 : bounds.sizes().maxCoeff() / std::sqrt(static_cast<double>(points_.size()));
  side_ = std::max(spacing, 2 * tolerance);
  for (std::size_t i = 0; i < points_.size(); ++i) entries_.push_back({box_of(points_[i]), static_cast<int>(i)});
  std::ranges::sort(entries_, {}, &Entry::box);
}

std::array<long, 3> PointLookup::box_of(const Vector3& place) const {
  const auto along = [&](double x) { return static_cast<long>(std::floor(x / side_)); };
  return {along(place.x()), along(place.y()), along(place.z())};
}

std::optional<int> PointLookup::find(const Vector3& place) const {
  const Vector3 reach = Vector3::Constant(tolerance_);
  const auto low = box_of(place - reach), high = box_of(place + reach);
  std::optional<int> nearest;
  double distance = tolerance_;
  for (long i = low[0]; i <= high[0]; ++i)
    for (long j = low[1]; j <= high[1]; ++j)
      for (long k = low[2]; k <= high[2]; ++k) {
        const std::array box{i, j, k};
        for (auto entry = std::ranges::lower_bound(entries_, box, {}, &Entry::box);
             entry != entries_.end() && entry->box == box; ++entry) {
          const double d = (points_[static_cast<std::size_t>(entry->point)] - place).norm();
          if (d <= distance) nearest = entry->point, distance = d;
        }
      }
  return nearest;
}

}  // namespace sundrape

#include "sundrape/force/obstacle_box.hpp"

#include <stdexcept>

#include "offset_surface.hpp"

namespace sundrape {

BoxObstacle::BoxObstacle(const Vector3& size, double edge_radius)
    : core_((0.5 * size).array() - edge_radius), edge_radius_(edge_radius) {
  if (!(size.minCoeff() > 0)) throw std::invalid_argument("the sizes of a box must be positive");
  if (!(edge_radius >= 0 && edge_radius <= 0.5 * size.minCoeff()))
    throw std::invalid_argument("the edge radius of a box must lie between 0 and half its smallest size");
}

Distance BoxObstacle::distance(const Vector3& x) const {
  const auto d = distance_to_rounded_box<3>(x, core_, edge_radius_);
  return {d.gap, d.normal, d.curvature};
}

Eigen::AlignedBox3d BoxObstacle::bounds() const {
  const Vector3 half = core_.array() + edge_radius_;
  return {-half, half};
}

}  // namespace sundrape

#include "sundrape/force/obstacle_sphere.hpp"

#include <stdexcept>

#include "offset_surface.hpp"

namespace sundrape {

SphereObstacle::SphereObstacle(double radius) : radius_(radius) {
  if (!(radius > 0)) throw std::invalid_argument("a sphere's radius must be positive");
}

Distance SphereObstacle::distance(const Vector3& x) const {
  const auto d = distance_to_ball<3>(x, radius_);
  return {d.gap, d.normal, d.curvature};
}

Eigen::AlignedBox3d SphereObstacle::bounds() const { return {Vector3::Constant(-radius_), Vector3::Constant(radius_)}; }

}  // namespace sundrape

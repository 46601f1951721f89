#include "sundrape/force/obstacle_capsule.hpp"

#include <algorithm>
#include <stdexcept>

#include "offset_surface.hpp"

namespace sundrape {

CapsuleObstacle::CapsuleObstacle(double radius, double length) : radius_(radius), half_length_(0.5 * length) {
  if (!(radius > 0 && length >= 0))
    throw std::invalid_argument("a capsule's radius must be positive and its length not negative");
}

Distance CapsuleObstacle::distance(const Vector3& x) const {
  const double nearest = std::clamp(x.z(), -half_length_, half_length_);  // on the axis
  if (std::abs(x.z()) > half_length_) {
    const auto cap = distance_to_ball<3>(x - Vector3(0, 0, nearest), radius_);
    return {cap.gap, cap.normal, cap.curvature};
  }
  const auto side = distance_to_ball<2>(x.head<2>(), radius_);
  Distance full{side.gap, Vector3(side.normal.x(), side.normal.y(), 0), Matrix3::Zero()};
  full.curvature.topLeftCorner<2, 2>() = side.curvature;
  return full;
}

Eigen::AlignedBox3d CapsuleObstacle::bounds() const {
  const Vector3 half(radius_, radius_, half_length_ + radius_);
  return {-half, half};
}

}  // namespace sundrape

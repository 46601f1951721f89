#include "sundrape/force/obstacle_cylinder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "offset_surface.hpp"

namespace sundrape {

CylinderObstacle::CylinderObstacle(double radius, double length, double edge_radius)
    : radius_(radius), half_length_(0.5 * length), edge_radius_(edge_radius) {
  if (!(radius > 0 && length > 0)) throw std::invalid_argument("a cylinder's radius and length must be positive");
  if (!(edge_radius >= 0 && edge_radius <= std::min(radius, half_length_)))
    throw std::invalid_argument("the edge radius of a cylinder must lie between 0 and its radius and half its length");
}

Distance CylinderObstacle::distance(const Vector3& x) const {
  // in the half-plane through the axis: r outward, z along
  const double from_axis = std::hypot(x.x(), x.y());
  const double r = std::max(from_axis, 1e-100);  // on the axis the limit is wanted
  const auto d =
      distance_to_rounded_box<2>({r, x.z()}, {radius_ - edge_radius_, half_length_ - edge_radius_}, edge_radius_);
  Eigen::Matrix<double, 3, 2> frame;
  frame.col(0) = from_axis > 0 ? Vector3(x.x() / r, x.y() / r, 0) : Vector3::UnitX();
  frame.col(1) = Vector3::UnitZ();
  Distance full{d.gap, frame * d.normal, frame * d.curvature * frame.transpose()};
  // Going round the axis turns the normal; nearest to the side, the axis itself is medial.
  if (from_axis > 0 || std::abs(d.normal.x()) < 1) {
    const Vector3 around(-frame(1, 0), frame(0, 0), 0);
    full.curvature += d.normal.x() / r * around * around.transpose();
  }
  return full;
}

Eigen::AlignedBox3d CylinderObstacle::bounds() const {
  const Vector3 half(radius_, radius_, half_length_);
  return {-half, half};
}

}  // namespace sundrape

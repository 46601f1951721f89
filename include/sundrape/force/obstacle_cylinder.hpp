#pragma once
#include "sundrape/force/obstacle.hpp"

namespace sundrape {

/// A finite cylinder along the z axis, centred at the origin, its two rims rounded to a radius.
class CylinderObstacle final : public Obstacle {
 public:
  /// @param length       from end face to end face [m]
  /// @param edge_radius  [m]
  /// @throws std::invalid_argument  unless radius, length > 0 and 0 ≤ edge_radius ≤ min(radius, length / 2)
  CylinderObstacle(double radius, double length, double edge_radius);

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override;

 private:
  double radius_, half_length_, edge_radius_;
};

}  // namespace sundrape

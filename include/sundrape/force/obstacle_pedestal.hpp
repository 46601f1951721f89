#pragma once
#include "sundrape/force/obstacle_cylinder.hpp"

namespace sundrape {

/// A round pedestal under the origin, as a drape tester has: a cylinder along z whose top is the plane z = 0.
class PedestalObstacle final : public Obstacle {
 public:
  /// @param height       from top to bottom [m]
  /// @param edge_radius  of the rims [m]
  /// @throws std::invalid_argument  unless radius, height > 0 and 0 ≤ edge_radius ≤ min(radius, height / 2)
  PedestalObstacle(double radius, double height, double edge_radius);

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override;

 private:
  CylinderObstacle cylinder_;
  Vector3 centre_;
};

}  // namespace sundrape

#pragma once
#include "sundrape/force/obstacle.hpp"

namespace sundrape {

/// A box about the origin whose edges and corners are rounded to a radius.
///
/// With edge_radius = 0 the normal turns by 90° at an edge within no distance, and contact there is as abrupt.
class BoxObstacle final : public Obstacle {
 public:
  /// @param size         full lengths along x, y, z [m]
  /// @param edge_radius  [m]
  /// @throws std::invalid_argument  unless every size > 0 and 0 ≤ edge_radius ≤ half the smallest size
  BoxObstacle(const Vector3& size, double edge_radius);

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override;

 private:
  Vector3 core_;  // half sizes of the box whose offset by the edge radius this is
  double edge_radius_;
};

}  // namespace sundrape

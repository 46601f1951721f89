#pragma once
#include "sundrape/force/obstacle.hpp"

namespace sundrape {

/// All points within a radius of a piece of the z axis that is centred at the origin.
class CapsuleObstacle final : public Obstacle {
 public:
  /// @param radius  [m]
  /// @param length  between the centres of the caps [m]
  /// @throws std::invalid_argument  unless radius > 0 and length ≥ 0
  CapsuleObstacle(double radius, double length);

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override;

 private:
  double radius_, half_length_;
};

}  // namespace sundrape

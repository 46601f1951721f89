#pragma once
#include "sundrape/force/obstacle.hpp"

namespace sundrape {

/// The half-space below a plane: gap = n·(x − p).
class PlaneObstacle final : public Obstacle {
 public:
  /// @param point   on the plane [m]
  /// @param normal  towards the free side, of any length
  /// @throws std::invalid_argument  a normal of zero length
  PlaneObstacle(const Vector3& point, const Vector3& normal);

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override;

 private:
  Vector3 point_, normal_;
};

}  // namespace sundrape

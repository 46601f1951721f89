#pragma once
#include "sundrape/force/obstacle.hpp"

namespace sundrape {

/// A ball about the origin: gap = |x| − R.
class SphereObstacle final : public Obstacle {
 public:
  /// @param radius  [m]
  /// @throws std::invalid_argument  unless radius > 0
  explicit SphereObstacle(double radius);

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override;

 private:
  double radius_;
};

}  // namespace sundrape

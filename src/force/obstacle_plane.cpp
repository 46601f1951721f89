#include "sundrape/force/obstacle_plane.hpp"

#include <limits>
#include <stdexcept>

namespace sundrape {

PlaneObstacle::PlaneObstacle(const Vector3& point, const Vector3& normal)
    : point_(point), normal_(normal.normalized()) {
  if (!(normal.norm() > 0)) throw std::invalid_argument("the normal of a plane must not be zero");
}

Distance PlaneObstacle::distance(const Vector3& x) const { return {normal_.dot(x - point_), normal_, Matrix3::Zero()}; }

Eigen::AlignedBox3d PlaneObstacle::bounds() const {
  const Vector3 everywhere = Vector3::Constant(std::numeric_limits<double>::infinity());
  return {-everywhere, everywhere};
}

}  // namespace sundrape

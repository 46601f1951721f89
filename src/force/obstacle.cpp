#include "sundrape/force/obstacle.hpp"

#include <stdexcept>
#include <utility>

namespace sundrape {

Matrix3 rotation_of_z_to(const Vector3& axis) {
  if (!(axis.norm() > 0)) throw std::invalid_argument("an axis must not be zero");
  return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axis).toRotationMatrix();
}

PlacedObstacle::PlacedObstacle(std::unique_ptr<const Obstacle> shape, const RigidPlacement& placement)
    : shape_(std::move(shape)), placement_(placement) {
  if (!shape_) throw std::invalid_argument("a placement needs a shape");
  const auto& r = placement_.rotation;
  if (!(r * r.transpose()).isApprox(Matrix3::Identity(), 1e-9) || !(r.determinant() > 0))
    throw std::invalid_argument("the matrix of a placement is no rotation");
}

Distance PlacedObstacle::distance(const Vector3& x) const {
  return turned(shape_->distance(placement_.inverse(x)), placement_.rotation);
}

Eigen::AlignedBox3d PlacedObstacle::bounds() const {
  const auto local = shape_->bounds();
  if (!local.sizes().allFinite()) return local;  // a plane reaches everywhere, however it is turned
  const Vector3 centre = placement_(local.center());
  const Vector3 half = 0.5 * (placement_.rotation.cwiseAbs() * local.sizes());
  return {centre - half, centre + half};
}

}  // namespace sundrape

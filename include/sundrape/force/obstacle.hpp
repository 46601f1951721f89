#pragma once
#include <memory>

#include <Eigen/Geometry>

#include "sundrape/mesh/rigid_placement.hpp"

namespace sundrape {

/// Signed distance to a surface and its first two derivatives at one point.
struct Distance {
  double gap;         // [m], positive outside
  Vector3 normal;     // ∇gap, of unit length; of a MeshObstacle shorter next to edges
  Matrix3 curvature;  // ∇∇gap [1/m], symmetric; a normal of unit length is in its null space
};

/// A distance as seen after a rotation of body and point.
[[nodiscard]] inline Distance turned(const Distance& d, const Matrix3& rotation) {
  return {d.gap, rotation * d.normal, rotation * d.curvature * rotation.transpose()};
}

/// A rigid body that cloth can touch.
///
/// Outside, the distance is the Euclidean distance to the surface, and so it is inside down to the medial axis; on the
/// axis itself, where several surface points are equally near, the normal is that of one of them.
class Obstacle {
 public:
  virtual ~Obstacle() = default;
  [[nodiscard]] virtual Distance distance(const Vector3& x) const = 0;
  /// An axis-aligned box around the body; infinite where the body is.
  [[nodiscard]] virtual Eigen::AlignedBox3d bounds() const = 0;
};

/// The shortest rotation that takes the z axis to `axis`, which may have any length.
/// @throws std::invalid_argument  an axis of zero length
[[nodiscard]] Matrix3 rotation_of_z_to(const Vector3& axis);

/// A body that stands somewhere else than it was made.
class PlacedObstacle final : public Obstacle {
 public:
  /// @throws std::invalid_argument  no shape, or a matrix that is no rotation (to 1e-9)
  PlacedObstacle(std::unique_ptr<const Obstacle> shape, const RigidPlacement& placement);

  [[nodiscard]] Distance distance(const Vector3& x) const override;
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override;

 private:
  std::unique_ptr<const Obstacle> shape_;
  RigidPlacement placement_;
};

}  // namespace sundrape

#include "sundrape/mesh/rigid_path.hpp"

#include <Eigen/Geometry>

namespace sundrape {

Vector3 carried_along(const RigidPath& path, double share, const Vector3& x) {
  if (const auto* line = std::get_if<LinePath>(&path)) return x + share * line->by;
  const auto& arc = std::get<ArcPath>(path);
  return arc.centre + Eigen::AngleAxisd(share * arc.angle, arc.axis) * (x - arc.centre);
}

}  // namespace sundrape

#include "sundrape/mesh/rigid_path.hpp"

#include <Eigen/Geometry>

namespace sundrape {
namespace {

RigidPlacement turned(const Vector3& centre, const Vector3& axis, double angle) {
  const Matrix3 rotation = Eigen::AngleAxisd(angle, axis).matrix();
  return {rotation, centre - rotation * centre};
}

RigidRate turning(const Vector3& centre, const Vector3& axis, double rate) {
  const Vector3 spin = rate * axis;
  return {spin, -spin.cross(centre)};
}

double duration(const KeyframePath& path) { return path.keyframes.times().back() - path.keyframes.times().front(); }
double time_at(const KeyframePath& path, double share) {
  return path.keyframes.times().front() + share * duration(path);
}

RigidPlacement placed(const LinePath& line, double share) { return {Matrix3::Identity(), share * line.by}; }
RigidPlacement placed(const ArcPath& arc, double share) { return turned(arc.centre, arc.axis, share * arc.angle); }
RigidPlacement placed(const KeyframePath& path, double share) {
  const Vector at = path.keyframes.value(time_at(path, share));
  auto placement = turned(path.centre, path.axis, at[3]);
  placement.translation += at.head<3>();
  return placement;
}

RigidRate moved(const LinePath& line, double /*share*/) { return {Vector3::Zero(), line.by}; }
RigidRate moved(const ArcPath& arc, double /*share*/) { return turning(arc.centre, arc.axis, arc.angle); }
RigidRate moved(const KeyframePath& path, double share) {
  const double time = time_at(path, share);
  const Vector at = path.keyframes.value(time), rate = duration(path) * path.keyframes.rate(time);
  auto moving = turning(path.centre + at.head<3>(), path.axis, rate[3]);
  moving.velocity += rate.head<3>();
  return moving;
}

}  // namespace

RigidPlacement placement_along(const RigidPath& path, double share) {
  return std::visit([&](const auto& p) { return placed(p, share); }, path);
}

RigidRate rate_along(const RigidPath& path, double share) {
  return std::visit([&](const auto& p) { return moved(p, share); }, path);
}

}  // namespace sundrape

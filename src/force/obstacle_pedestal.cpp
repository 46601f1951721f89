#include "sundrape/force/obstacle_pedestal.hpp"

namespace sundrape {

PedestalObstacle::PedestalObstacle(double radius, double height, double edge_radius)
    : cylinder_(radius, height, edge_radius), centre_(0, 0, -0.5 * height) {}

Distance PedestalObstacle::distance(const Vector3& x) const { return cylinder_.distance(x - centre_); }

Eigen::AlignedBox3d PedestalObstacle::bounds() const { return cylinder_.bounds().translated(centre_); }

}  // namespace sundrape

#include "sundrape/system/point_map.hpp"

namespace sundrape {

Vector PointMap::turn(const ConstVectorRef& f) const {
  Vector turned(f.size());
  for (int i = 0; i < static_cast<int>(image.size()); ++i)
    point(turned, image[static_cast<std::size_t>(i)]) = (i < places ? 1 : side) * (rotation * point(f, i));
  return turned;
}

Vector PointMap::move(const ConstVectorRef& q) const {
  Vector moved = turn(q);
  const Vector3 shift = centre - rotation * centre;
  for (int i = 0; i < places; ++i) point(moved, i) += shift;
  return moved;
}

}  // namespace sundrape

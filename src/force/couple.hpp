#pragma once
#include <Eigen/Geometry>

#include "sundrape/types.hpp"

namespace sundrape {

/// The force at the end of an arm that has the moment m about every axis across the arm: m × r/|r|².
inline Vector3 couple(const Vector3& moment, const Vector3& arm) { return moment.cross(arm) / arm.squaredNorm(); }

/// Its derivative by the arm.
inline Matrix3 couple_by_arm(const Vector3& moment, const Vector3& arm) {
  const double square = arm.squaredNorm();
  return cross_matrix(moment) / square - 2 * moment.cross(arm) * arm.transpose() / (square * square);
}

}  // namespace sundrape

#pragma once
#include <Eigen/Core>

namespace sundrape {

/// Signed distance in D dimensions with its first two derivatives.
template <int D>
struct DistanceIn {
  double gap;
  Eigen::Matrix<double, D, 1> normal;
  Eigen::Matrix<double, D, D> curvature;
};

/// Distance to a sphere about the origin, where `offset` = x. At its centre the normal is that of the last axis.
template <int D>
DistanceIn<D> distance_to_ball(const Eigen::Matrix<double, D, 1>& offset, double radius) {
  using Square = Eigen::Matrix<double, D, D>;
  const double length = offset.norm();
  if (!(length > 0)) return {-radius, Eigen::Matrix<double, D, 1>::Unit(D - 1), Square::Zero()};
  const Eigen::Matrix<double, D, 1> normal = offset / length;
  return {length - radius, normal, (Square::Identity() - normal * normal.transpose()) / length};
}

/// Distance to the surface at a distance `radius` from a box |x_k| ≤ core_k.
///
/// Inside the core the nearest point lies on the nearest face. Elsewhere it is found by clamping: only the components
/// that stick out of the core count, and over them the surface is a sphere.
template <int D>
DistanceIn<D> distance_to_rounded_box(const Eigen::Matrix<double, D, 1>& x, const Eigen::Matrix<double, D, 1>& core,
                                      double radius) {
  using Column = Eigen::Matrix<double, D, 1>;
  using Square = Eigen::Matrix<double, D, D>;
  const Column excess = x.cwiseAbs() - core;
  const Column signs = (x.array() < 0).select(-Column::Ones(), Column::Ones());
  // 1 where a component sticks out of the core, as all do where the core is flat
  const Column outside = (excess.array() > 0 || core.array() <= 0).template cast<double>();
  int face = 0;
  const double deepest = excess.maxCoeff(&face);
  if (outside.sum() <= 1 || deepest <= 0) return {deepest - radius, signs[face] * Column::Unit(face), Square::Zero()};

  const Column offset = excess.cwiseProduct(outside);
  const double length = offset.norm();
  const Column normal = offset.cwiseProduct(signs) / length;
  const Square identity = outside.asDiagonal();
  return {length - radius, normal, (identity - normal * normal.transpose()) / length};
}

}  // namespace sundrape

#pragma once
#include "sundrape/app/case_symmetries.hpp"

namespace sundrape {

/// How far two states of one case are apart once they are laid on each other as well as the case allows.
struct ShapeDistance {
  double rms = 0, max = 0;             // over the nodes [m]
  std::size_t map = 0;                 // the symmetry that lays b on a
  Vector aligned;                      // b under it and the best neutral motion, 3P [m]
  Matrix3 turn = Matrix3::Identity();  // of that neutral motion
};

/// The smallest RMS node distance over the case's symmetries, and over its neutral rigid motions if there are any.
/// @param nodes  N; only places count, not directors
/// @param a, b   states of all points, 3P [m]
[[nodiscard]] ShapeDistance shape_distance(const CaseSymmetries& symmetries, int nodes, const Vector& a,
                                           const Vector& b);

}  // namespace sundrape

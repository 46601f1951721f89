#pragma once
#include <Eigen/Core>

namespace sundrape {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Vector = Eigen::VectorXd;
using VectorRef = Eigen::Ref<Eigen::VectorXd>;
using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;

/// A configuration and its rate at one instant.
///
/// Shapes: q and v hold one 3-vector a point, 3P in all; point i owns entries 3i, 3i+1, 3i+2.
/// The points of a particle net are its nodes; a shell has its nodes, then a director of length ℓ for each.
struct State {
  double time;       // [s]; in staged statics the load factor of the stage
  ConstVectorRef q;  // coordinates [m]
  ConstVectorRef v;  // their rates [m/s]
  int stage = 0;     // of staged statics, from 1 on; 0: loads and paths go by time; or statics_by_time
};

/// Stage of a state whose loads and supports are where they are at a time, but rest there.
inline constexpr int statics_by_time = -1;

/// The 3-vector that belongs to point i, as something to read or to write.
inline auto point(ConstVectorRef& x, int i) { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); }
inline auto point(const ConstVectorRef& x, int i) { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); }
inline auto point(VectorRef& x, int i) { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); }
inline auto point(Vector& x, int i) { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); }
inline auto point(const Vector& x, int i) { return x.segment<3>(3 * static_cast<Eigen::Index>(i)); }

/// The matrix of w×, so that cross_matrix(w) * x = w.cross(x).
inline Matrix3 cross_matrix(const Vector3& w) {
  Matrix3 m;
  m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return m;
}

}  // namespace sundrape

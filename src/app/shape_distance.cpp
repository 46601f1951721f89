#include "sundrape/app/shape_distance.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace sundrape {
namespace {

Eigen::Map<const Eigen::Matrix3Xd> columns(const Vector& q, int nodes) { return {q.data(), 3, nodes}; }

/// The angle about the vertical that turns b closest to a, both counted from their centres (Kabsch in the plane).
double best_angle(const Vector& a, const Vector& b, int nodes, const Vector3& centre_a, const Vector3& centre_b) {
  const auto x = columns(a, nodes).colwise() - centre_a, y = columns(b, nodes).colwise() - centre_b;
  const double sine = y.row(0).dot(x.row(1)) - y.row(1).dot(x.row(0));
  const double cosine = y.row(0).dot(x.row(0)) + y.row(1).dot(x.row(1));
  return std::atan2(sine, cosine);
}

/// Moves b by the neutral motion that brings it closest to a; returns how that turns it.
Matrix3 lay_on(const NeutralMotions& neutral, int nodes, const Vector& a, Vector& b) {
  Matrix3 turn = Matrix3::Identity();
  if (neutral.pivot) {
    const bool slides = neutral.slides.size() == 2;  // then every axis will do, and that through the middles is best
    const Vector3 centre_a = slides ? Vector3(columns(a, nodes).rowwise().mean()) : *neutral.pivot;
    const Vector3 centre_b = slides ? Vector3(columns(b, nodes).rowwise().mean()) : *neutral.pivot;
    turn = Eigen::AngleAxisd(best_angle(a, b, nodes, centre_a, centre_b), Vector3::UnitZ()).matrix();
    for (int p = 0; p < static_cast<int>(b.size() / 3); ++p)
      point(b, p) = p < nodes ? Vector3(turn * (point(b, p) - centre_b) + centre_b) : Vector3(turn * point(b, p));
  }
  if (!neutral.slides.empty()) {
    const Vector3 apart = (columns(a, nodes) - columns(b, nodes)).rowwise().mean();
    for (const auto& slide : neutral.slides)
      for (int i = 0; i < nodes; ++i) point(b, i) += slide.dot(apart) * slide;
  }
  return turn;
}

}  // namespace

ShapeDistance shape_distance(const CaseSymmetries& symmetries, int nodes, const Vector& a, const Vector& b) {
  ShapeDistance best{.rms = std::numeric_limits<double>::infinity(), .aligned = {}};
  for (std::size_t m = 0; m < symmetries.maps.size(); ++m) {
    Vector moved = symmetries.maps[m].move(b);
    Matrix3 turn = Matrix3::Identity();
    if (symmetries.neutral.any()) turn = lay_on(symmetries.neutral, nodes, a, moved);
    const auto apart = (columns(a, nodes) - columns(moved, nodes)).colwise().norm();
    const double rms = std::sqrt(apart.squaredNorm() / nodes);
    if (rms < best.rms)
      best = {.rms = rms, .max = apart.maxCoeff(), .map = m, .aligned = std::move(moved), .turn = turn};
  }
  return best;
}

}  // namespace sundrape

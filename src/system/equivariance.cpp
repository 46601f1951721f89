#include "sundrape/system/equivariance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sundrape {
namespace {

/// Forces by kind, 3P each [N].
std::map<EnergyKind, Vector> forces_by_kind(const System& system, const Vector& q) {
  const Vector still = Vector::Zero(q.size());
  std::map<EnergyKind, Vector> forces;
  for (const auto& term : system.terms()) {
    auto [entry, fresh] = forces.try_emplace(term->kind());
    if (fresh) entry->second = Vector::Zero(q.size());
    term->add_force({after_everything, q, still}, entry->second);
  }
  return forces;
}

/// Projection onto the held components of a point.
Matrix3 held_part(const Unknowns& unknowns, int p) {
  Matrix3 part = Matrix3::Zero();
  for (int k = 0; k < 3; ++k) part(k, k) = unknowns.is_held(p, k) ? 1 : 0;
  return part;
}

}  // namespace

double equivariance_defect(const System& system, const PointMap& map, const Vector& q) {
  const auto before = forces_by_kind(system, q), after = forces_by_kind(system, map.move(q));
  double worst = 0;
  for (const auto& [kind, force] : before) {
    const Vector& moved = after.at(kind);
    const double size = std::max(force.norm(), moved.norm());
    if (!std::isfinite(size)) return std::numeric_limits<double>::infinity();
    if (size > 0) worst = std::max(worst, (moved - map.turn(force)).norm() / size);
  }
  return worst;
}

bool maps_supports(const Unknowns& unknowns, const PointMap& map, const Vector& held, double tolerance) {
  const Vector moved = map.move(held);
  for (int i = 0; i < unknowns.points(); ++i) {
    const int j = map.image[static_cast<std::size_t>(i)];
    const Matrix3 there = held_part(unknowns, j);
    if (!there.isApprox(map.rotation * held_part(unknowns, i) * map.rotation.transpose(), 1e-4) &&
        !(there.isZero() && held_part(unknowns, i).isZero()))
      return false;
    if ((there * (point(moved, j) - point(held, j))).norm() > tolerance) return false;
  }
  return true;
}

}  // namespace sundrape

#include "sundrape/statics/static_sensitivity.hpp"

namespace sundrape {

bool StaticSensitivity::move_to(const State& equilibrium) {
  time_ = equilibrium.time;
  stage_ = equilibrium.stage;
  q_ = equilibrium.q;
  const Vector still = Vector::Zero(q_.size());
  forces_.evaluate({time_, q_, still, stage_});
  return tangent_.factor(equilibrium) == FactorStatus::ok;
}

std::optional<Vector> StaticSensitivity::derivative(ParameterDerivative& by) {
  const auto& unknowns = system_.unknowns();
  Vector right_side(unknowns.size()), rows(unknowns.size());
  by.force(forces_, right_side);
  if (!tangent_.solve_stiffness(right_side, rows).ok || !rows.allFinite()) return std::nullopt;
  Vector s(q_.size()), supports_v(q_.size());
  by.supports(time_, stage_, s, supports_v);
  for (int r = 0; r < unknowns.rows(); ++r) {
    const int p = unknowns.point_of_row()[static_cast<std::size_t>(r)];
    for (int k = 0; k < 3; ++k)
      if (!unknowns.is_held(p, k)) s[3 * p + k] = rows[3 * r + k];
  }
  return s;
}

}  // namespace sundrape

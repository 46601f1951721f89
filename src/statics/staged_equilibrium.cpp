#include "sundrape/statics/staged_equilibrium.hpp"

#include <algorithm>

namespace sundrape {
namespace {

// Steps of the differences by λ: loads are linear in it, paths of supports are not, and the cloth is stiff.
constexpr double load_step = 1e-4, motion_step = 1e-7;
constexpr double least_share = 1e-3;  // of the full load, in the scale of residuals

}  // namespace

StagedEquilibrium::StagedEquilibrium(const System& system, int stage, const Vector& q, double force_scale)
    : system_(system),
      stage_(stage),
      force_scale_(force_scale),
      still_(Vector::Zero(3 * system.mass().size())),
      f_(still_),
      rows_(system.unknowns().size()) {
  full_load_ = system.external_force_norm(state(q, 1));
}

const Vector& StagedEquilibrium::out_of_balance(const Vector& q, double load_factor) {
  system_.force(state(q, load_factor), f_);
  system_.unknowns().gather(f_, rows_);
  system_.unknowns().clear_held(rows_);
  return rows_;
}

Vector StagedEquilibrium::load_direction(const Vector& q, double load_factor) {
  const double step = system_.has_motions() ? motion_step : load_step;
  Vector moved = q;
  system_.carry(load_factor + step, stage_, moved);
  Vector direction = out_of_balance(moved, load_factor + step);
  moved = q;
  system_.carry(load_factor - step, stage_, moved);
  direction -= out_of_balance(moved, load_factor - step);
  return direction / (2 * step);
}

double StagedEquilibrium::force_scale(const Vector& q, double load_factor) const {
  const double loads = system_.external_force_norm(state(q, load_factor));
  const double scale = std::max(loads, least_share * full_load_);
  if (scale > 0) return scale;
  const double reactions = std::sqrt(system_.unknowns().held_dot(f_, f_));  // f_ has them where points are held
  return std::max(reactions, least_share * force_scale_);
}

void StagedEquilibrium::move(Vector& q, const Vector& increment, double load_factor) const {
  Vector rows(increment.size());
  system_.unknowns().gather(q, rows);
  rows += increment;
  system_.unknowns().scatter(rows, q);
  system_.carry(load_factor, stage_, q);
}

}  // namespace sundrape

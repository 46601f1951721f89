#pragma once
#include "sundrape/system/system.hpp"

namespace sundrape {

/// Equilibrium of a system in one stage of its loads and prescribed motions, as equations in the unknowns and the load
/// factor λ (17): which forces are out of balance, and how they change with λ.
class StagedEquilibrium {
 public:
  /// @param q            all points, 3P [m], where the stage begins
  /// @param force_scale  what residuals are compared with where nothing pulls at the cloth [N]
  StagedEquilibrium(const System& system, int stage, const Vector& q, double force_scale);

  [[nodiscard]] int stage() const { return stage_; }
  [[nodiscard]] State state(const Vector& q, double load_factor) const { return {load_factor, q, still_, stage_}; }

  /// F_ext − P (24): forces out of balance, rows, 3n [N]; held components are zero. q: all points, carried to where
  /// they are at this load factor.
  [[nodiscard]] const Vector& out_of_balance(const Vector& q, double load_factor);
  /// F_0 = ∂F/∂λ − ∂P/∂λ (26), rows, 3n [N], by central differences: exact for loads in proportion to λ, and for
  /// supports that move it spares the stiffness that ties the unknowns to them.
  [[nodiscard]] Vector load_direction(const Vector& q, double load_factor);
  /// The force that the last out_of_balance() is to be compared with [N]: that of the loads at this load factor, but
  /// not less than a thousandth of the stage's; reactions where only supports act.
  [[nodiscard]] double force_scale(const Vector& q, double load_factor) const;
  /// Adds an increment of the unknowns (rows) and carries the moved points to `load_factor`.
  void move(Vector& q, const Vector& increment, double load_factor) const;

 private:
  const System& system_;
  int stage_;
  double force_scale_;
  double full_load_;  // |loads| at the end of the stage [N]
  Vector still_, f_, rows_;
};

}  // namespace sundrape

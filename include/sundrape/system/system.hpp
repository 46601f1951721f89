#pragma once
#include <memory>
#include <vector>

#include "sundrape/force/force_term.hpp"
#include "sundrape/system/prescribed_motion.hpp"
#include "sundrape/system/unknowns.hpp"

namespace sundrape {

/// The semidiscrete system  M a = Σ f_k(q, v, t)  of one cloth: masses, force terms, supports, sparsity.
///
/// Integrators and statics see only this class. Vectors named "all" hold every point (3P); vectors of "rows" hold the
/// unknowns (3n). The mass matrix is lumped.
class System {
 public:
  /// @param mass   P [kg], ≥ 0; the rates of points without mass are algebraic unknowns
  /// @param terms  owned
  /// @param rest   coordinates of the held points, 3P [m] (the other entries are not read)
  /// @param motions  of points whose components are held, one after the other
  System(Vector mass, std::vector<std::unique_ptr<ForceTerm>> terms, Unknowns unknowns, Vector rest,
         std::vector<PrescribedMotion> motions = {});

  [[nodiscard]] const Unknowns& unknowns() const { return unknowns_; }
  [[nodiscard]] const Vector& mass() const { return mass_; }          // P [kg]
  [[nodiscard]] const Vector& row_mass() const { return row_mass_; }  // n [kg]
  /// Whether an unknown has no mass, so that only a solver of differential-algebraic equations takes the system.
  [[nodiscard]] bool has_massless_rows() const { return row_mass_.size() > 0 && row_mass_.minCoeff() == 0; }
  /// Whether ∂f/∂q is symmetric without damping.
  [[nodiscard]] bool has_symmetric_tangent() const;
  [[nodiscard]] const std::vector<std::unique_ptr<ForceTerm>>& terms() const { return terms_; }
  /// Of matrices over the unknowns: as it was built, or last adapted.
  [[nodiscard]] const BlockStructure& structure() const { return structure_; }
  /// How many structures there have been. What was made for an earlier one, matrices and analyses of solvers, is not to
  /// be used.
  [[nodiscard]] long structures() const { return structures_; }
  /// Gives the structure room for the tangent at a state, which terms may couple otherwise than before (cloth that
  /// touches cloth), and returns structures(): whoever has made matrices for another has to make them anew. Others who
  /// use the same system have to ask too before they use theirs.
  [[nodiscard]] long adapt(const State& all) const;
  [[nodiscard]] bool watches_passages() const;
  /// What a step straight from one state to another would have pass through each other.
  [[nodiscard]] std::optional<Passage> passage(const State& from, const State& to) const;
  /// Whether Newton's iteration may end with a correction from one iterate to the next.
  [[nodiscard]] bool settles(const State& before, const State& after) const;

  /// Has a motion take hold of points, and of directors that turn with them, where they are at a state: from then on
  /// they go where it goes. Points that are held for good stay with what holds them.
  void take_hold(std::size_t motion, const std::vector<int>& points, const std::vector<int>& directors,
                 const State& all);
  /// Has a motion let go of all that it carries; what else carries these points goes on from where they are.
  void let_go(std::size_t motion, const State& all);
  /// Has all that is carried go on from where it is at a state.
  void go_on_from(const State& all);

  /// Where what is held stands before motions carry it, 3P [m]; entries of what is free mean nothing.
  [[nodiscard]] const Vector& rest() const { return rest_; }
  [[nodiscard]] bool has_motions() const { return !motions_.empty(); }
  [[nodiscard]] const PrescribedMotion& motion(std::size_t index) const { return motions_[index]; }
  /// Puts the points that are carried along paths where they are at a time, or at a load factor of a stage; of q, 3P
  /// [m], no other entry changes.
  void carry(double time, int stage, VectorRef q) const { motions_.place(time, stage, rest_, q); }
  /// Accelerations of what is held [m/s²], 3P; zero elsewhere, and where supports do not move.
  [[nodiscard]] Vector held_acceleration(double time) const { return motions_.acceleration(time, rest_); }

  /// Every point's coordinates and rates at a time from the unknowns'.
  void expand(double time, ConstVectorRef rows_q, ConstVectorRef rows_v, VectorRef q, VectorRef v) const;

  /// Σ f_k, 3P [N]; f is overwritten.
  void force(const State& all, VectorRef f) const;
  /// matrix += dq ∂f/∂q + dv ∂f/∂v over the unknowns.
  void add_tangent(const State& all, double dq, double dv, BlockMatrix& matrix) const;
  /// Gives the held components of a matrix over the unknowns the equation "no change".
  void hold(BlockMatrix& matrix) const;
  /// The same with a given diagonal entry: 0 takes them out of a spectrum.
  void hold(BlockMatrix& matrix, double value) const;

  [[nodiscard]] Energies energies(const State& all) const;
  /// What the cloth stores by its deformation at each point, P [J]: membrane, shear and bending together.
  [[nodiscard]] Vector strain_energy(const State& all) const;
  [[nodiscard]] double kinetic_energy(const State& all) const;       // [J]
  [[nodiscard]] double held_kinetic_energy(const State& all) const;  // of components that are held and carried [J]
  /// Power that supports put in beyond what changes the kinetic energy of what they hold [W]: −Σ f v of held
  /// components.
  [[nodiscard]] double support_power(const State& all) const;
  [[nodiscard]] double dissipated_power(const State& all) const;  // [W]
  [[nodiscard]] double external_power(const State& all) const;    // [W]
  /// |forces of loads and gravity| over the unknowns [N]: what the out-of-balance force is compared with.
  [[nodiscard]] double external_force_norm(const State& all) const;

 private:
  /// Has all terms declare what they couple.
  void declare() const;

  Vector mass_, row_mass_;
  std::vector<std::unique_ptr<ForceTerm>> terms_;
  Unknowns unknowns_;
  Vector rest_;
  PrescribedMotions motions_;
  mutable BlockStructure structure_;       // storage, not physics
  mutable std::vector<SlotTable> tables_;  // one a term
  mutable long structures_ = 0;
};

}  // namespace sundrape

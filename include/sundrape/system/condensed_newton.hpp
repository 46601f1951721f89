#pragma once
#include <memory>

#include "sundrape/linalg/linear_solver.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape {

/// The Newton system of an implicit integrator with the rates eliminated: half the unknowns, and symmetric for forces
/// that have an energy.
///
/// With y = (q, v) an implicit step solves, for c = c_j (IDA) or 1/γ (CVODE),
///     c Δq − Δv = r_q,    c M Δv + K Δq + C Δv = r_v,    K = −∂f/∂q, C = −∂f/∂v,
/// and Δv = c Δq − r_q leaves   (c² M + c C + K) Δq = r_v + (c M + C) r_q.
/// The right side's C r_q is a difference of two forces, exact where damping is linear in the rates.
class CondensedNewton {
 public:
  struct Counters {
    long factorizations = 0, solves = 0, linear_iterations = 0, failures = 0, patterns = 0;
    double assembly_seconds = 0, factor_seconds = 0, solve_seconds = 0;  // wall clock
  };

  /// @param tolerance  of the linear solves, relative to the first right side for one time and c: later iterations of a
  ///                   step make do with fewer digits
  CondensedNewton(const System& system, std::unique_ptr<LinearSolver> solver, double tolerance);

  /// Assembles and factors c² M + c C + K at a state of the unknowns (rows, 3n).
  FactorStatus prepare(double time, double c, ConstVectorRef q, ConstVectorRef v);
  /// Whether the matrix at hand was prepared for this time and c.
  [[nodiscard]] bool is_prepared_for(double time, double c) const { return ready_ && time == time_ && c == c_; }
  /// Makes the next step prepare one of its own.
  void forget() { ready_ = false; }
  /// Tells the forces [N] over the unknowns where the matrix was assembled, if they are at hand: it saves evaluating
  /// them.
  void know_forces(ConstVectorRef rows);
  /// All vectors are rows, 3n; r_v is a force [N], r_q a rate [m/s]. |dq| above `largest` [m] is of no use: an
  /// iterative solver may then give up.
  SolveReport solve(ConstVectorRef r_q, ConstVectorRef r_v, VectorRef dq, VectorRef dv,
                    double largest = std::numeric_limits<double>::infinity());

  [[nodiscard]] const Counters& counters() const { return counters_; }
  [[nodiscard]] LinearSolver& solver() { return *solver_; }
  /// The matrix last assembled.
  [[nodiscard]] const BlockMatrix& matrix() const { return matrix_; }

 private:
  void add_damping_product(ConstVectorRef r_q, VectorRef right_side);

  const System& system_;
  std::unique_ptr<LinearSolver> solver_;
  BlockMatrix matrix_;
  long of_structure_;  // that the matrix is for
  double tolerance_, c_ = 0, time_ = 0, first_norm_ = 0;
  Vector q_, v_;               // all points, where the matrix was assembled
  Vector shifted_v_, work_;    // all points, work
  Vector right_side_, force_;  // rows
  bool force_known_ = false;   // force_ is that where the matrix was assembled
  bool ready_ = false;         // the matrix is factored and wanted
  Counters counters_;
};

}  // namespace sundrape

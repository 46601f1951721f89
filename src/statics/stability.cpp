#include "sundrape/statics/stability.hpp"

#include "sundrape/linalg/inertia.hpp"
#include "sundrape/linalg/linear_solver.hpp"

namespace sundrape {

std::optional<int> negative_pivots(const System& system, const State& all, double neutral_frequency) {
  BlockMatrix matrix(system.structure(), Symmetry::symmetric);
  matrix.add_diagonal(system.row_mass(), neutral_frequency * neutral_frequency);
  const Vector still = Vector::Zero(all.v.size());
  system.add_tangent({all.time, all.q, still}, -1, 0, matrix);
  system.hold(matrix);
  // most equilibria are stable, and a supernodal Cholesky factorisation says so several times faster
  if (make_linear_solver(SolverKind::cholesky)->factor(matrix) == FactorStatus::ok) return 0;
  return negative_eigenvalues(matrix);
}

}  // namespace sundrape

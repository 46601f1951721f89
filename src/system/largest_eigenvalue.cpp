#include "sundrape/system/largest_eigenvalue.hpp"

#include "sundrape/linalg/power_iteration.hpp"

namespace sundrape {

double largest_eigenvalue(const System& system, const State& all, double dq, double dv, ConstVectorRef weight) {
  (void)system.adapt(all);
  BlockMatrix matrix(system.structure(), Symmetry::symmetric);
  system.add_tangent(all, dq, dv, matrix);
  system.hold(matrix, 0);
  return largest_eigenvalue(matrix, weight);
}

}  // namespace sundrape

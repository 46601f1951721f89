#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "sundrape/linalg/block_matrix.hpp"

namespace sundrape {

enum class FactorStatus { ok, not_positive_definite, singular };

struct SolveReport {
  bool ok = true;
  int iterations = 0;        // of an iterative solver; 0 for a direct one
  std::string problem = {};  // what went wrong, empty if nothing
  bool indefinite = false;   // the solver failed since it found the matrix not to be positive definite
};

/// Solves A x = b for one matrix after another on the same structure.
///
/// analyse() once a structure (again only when it changes), factor() once a matrix, solve() as often as wanted. The
/// structure must live as long as the solver works on it, and the matrix must stay as it is from factor() to the last
/// solve(): iterative solvers read it again.
/// A multigrid preconditioner, a direct factorisation and a matrix-free method all fit behind it.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// What the solver wants assembled.
  [[nodiscard]] virtual Symmetry symmetry() const = 0;
  virtual void analyse(const BlockStructure& structure) = 0;
  [[nodiscard]] virtual FactorStatus factor(const BlockMatrix& matrix) = 0;
  /// @param tolerance  on |b − A x| / |b|; direct solvers ignore it
  /// @param largest    |x| of a solution that is still of use: iterative solvers whose iterates only grow give up
  /// beyond b and x: 3n, may not overlap. x need not be set; after a failure of an iterative solver it is the iterate
  /// reached.
  [[nodiscard]] virtual SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance,
                                          double largest = std::numeric_limits<double>::infinity()) = 0;
  /// Solves for every column of b, each to about `tolerance`: where that is loose an iterative solver may trust its own
  /// recursion, and work on several columns at once. b, x: 3n × m. ok: all of them are; iterations: of all together.
  [[nodiscard]] virtual SolveReport solve_all(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance);
  /// Number of negative eigenvalues of the last factored matrix where the factor tells it (Sylvester's law of inertia).
  [[nodiscard]] virtual std::optional<int> negative_pivots() const { return std::nullopt; }
};

enum class SolverKind { conjugate_gradients, cholesky, lu };

/// @throws std::invalid_argument  a kind that this build does not have
[[nodiscard]] std::unique_ptr<LinearSolver> make_linear_solver(SolverKind kind);

}  // namespace sundrape

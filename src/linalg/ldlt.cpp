#include "sundrape/linalg/ldlt.hpp"

#include <algorithm>

#include "symmetric_factor.hpp"

namespace sundrape {
namespace {

constexpr double largest_backward_error = 1e-10;  // |b − A x| / (|b| + max|A| |x|) of a solution that is one
constexpr int most_refinements = 4;

}  // namespace

#ifdef SUNDRAPE_WITH_CHOLMOD
std::string_view Ldlt::name() const { return "LDLᵀ (CHOLMOD)"; }
#else
std::string_view Ldlt::name() const { return "LDLᵀ (Eigen)"; }
#endif

Ldlt::Ldlt() : factor_(std::make_unique<SymmetricFactor>(SymmetricFactor::Kind::indefinite)) {}
Ldlt::~Ldlt() = default;

void Ldlt::analyse(const BlockStructure& structure) { factor_->analyse(structure); }

FactorStatus Ldlt::factor(const BlockMatrix& matrix) {
  matrix_ = &matrix;
  return factor_->factor(matrix);
}

SolveReport Ldlt::solve(ConstVectorRef b, VectorRef x, double tolerance, double /*largest*/) {
  if (!factor_->negative_pivots()) return {.ok = false, .problem = "LDLᵀ: the last matrix could not be factored"};
  const double enough = std::max(tolerance, 1e-13) * b.norm();
  Vector correction = Vector::Zero(b.size()), product(b.size()), rest = b;
  x.setZero();
  double previous = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= most_refinements; ++k) {
    if (!factor_->solve(rest, correction)) return {.ok = false, .problem = "LDLᵀ: the triangular solves failed"};
    x += correction;
    if (!x.allFinite()) return {.ok = false, .problem = "LDLᵀ: the solution is not finite"};
    if (matrix_->symmetry() == Symmetry::unsymmetric) return {};  // what it solves is not that matrix
    matrix_->multiply(x, product);
    rest = b - product;
    const double size = rest.norm();
    if (size <= enough) return {};
    if (size > 0.5 * previous) break;
    previous = size;
  }
  if (rest.norm() <= largest_backward_error * (b.norm() + factor_->largest_entry() * x.norm())) return {};
  return {.ok = false, .problem = "LDLᵀ: its factor without pivoting is no good for this matrix"};
}

std::optional<int> Ldlt::negative_pivots() const { return factor_->negative_pivots(); }

std::optional<int> negative_eigenvalues(const BlockMatrix& matrix) {
  Ldlt ldlt;
  (void)ldlt.factor(matrix);
  return ldlt.negative_pivots();
}

}  // namespace sundrape

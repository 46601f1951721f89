#include "sundrape/linalg/cholesky.hpp"

#include <stdexcept>

#include "symmetric_factor.hpp"

namespace sundrape {

#ifdef SUNDRAPE_WITH_CHOLMOD
std::string_view Cholesky::name() const { return "Cholesky (CHOLMOD)"; }
#else
std::string_view Cholesky::name() const { return "Cholesky (Eigen)"; }
#endif

Cholesky::Cholesky() : factor_(std::make_unique<SymmetricFactor>(SymmetricFactor::Kind::definite)) {}
Cholesky::~Cholesky() = default;

void Cholesky::analyse(const BlockStructure& structure) { factor_->analyse(structure); }

FactorStatus Cholesky::factor(const BlockMatrix& matrix) {
  if (matrix.symmetry() != Symmetry::symmetric) throw std::invalid_argument("Cholesky wants a symmetric matrix");
  return factor_->factor(matrix);
}

SolveReport Cholesky::solve(ConstVectorRef b, VectorRef x, double /*tolerance*/, double /*largest*/) {
  if (!factor_->negative_pivots()) return {.ok = false, .problem = "Cholesky: the last matrix could not be factored"};
  if (!factor_->solve(b, x)) return {.ok = false, .problem = "Cholesky: the triangular solves failed"};
  if (!x.allFinite()) return {.ok = false, .problem = "Cholesky: the solution is not finite"};
  return {};
}

std::optional<int> Cholesky::negative_pivots() const { return factor_->negative_pivots(); }

}  // namespace sundrape

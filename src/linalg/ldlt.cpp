#include "sundrape/linalg/ldlt.hpp"

#include <algorithm>
#include <cmath>

#include "sundrape/linalg/compressed_columns.hpp"

#ifdef SUNDRAPE_WITH_CHOLMOD
#include "cholmod_handles.hpp"
#else
#include <Eigen/SparseCholesky>
#endif

namespace sundrape {
namespace {

constexpr double largest_backward_error = 1e-10;  // |b − A x| / (|b| + max|A| |x|) of a solution that is one
constexpr int most_refinements = 4;

/// Counts one pivot; false where it tells nothing.
bool count(double pivot, int& negative) {
  if (pivot < 0) ++negative;
  return pivot != 0 && std::isfinite(pivot);
}

}  // namespace

#ifdef SUNDRAPE_WITH_CHOLMOD

struct Ldlt::Parts {
  cholmod::Common common;
  std::optional<CompressedColumns> columns;
  cholmod::Factor factor{nullptr, {&common}};
  cholmod_dense* x = nullptr;  // workspaces of the solve, kept by CHOLMOD between calls
  cholmod_dense* y = nullptr;
  cholmod_dense* e = nullptr;

  Parts() {
    common->supernodal = CHOLMOD_SIMPLICIAL;
    common->final_ll = 0;
  }
  ~Parts() {
    for (auto** workspace : {&x, &y, &e}) cholmod_l_free_dense(workspace, common.get());
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void analyse() { factor = cholmod::analyse(*columns, common); }

  std::optional<int> factorise() {
    if (!cholmod::factorise(*columns, *factor, common)) return {};
    // The simplicial factor keeps D as the first entry of each column of L.
    const auto* start = static_cast<const SuiteSparse_long*>(factor->p);
    const auto* value = static_cast<const double*>(factor->x);
    int negative = 0;
    for (std::size_t column = 0; column < factor->n; ++column)
      if (!count(value[start[column]], negative)) return {};
    return negative;
  }

  bool solve(ConstVectorRef b, VectorRef solution) {
    Vector right_side = b;  // CHOLMOD wants it writable
    const cholmod::OneThread guard;
    auto view = cholmod::vector_view(right_side.data(), right_side.size());
    if (cholmod_l_solve2(CHOLMOD_A, factor.get(), &view, nullptr, &x, nullptr, &y, &e, common.get()) == 0) return false;
    solution = Eigen::Map<const Vector>(static_cast<const double*>(x->x), b.size());
    return true;
  }
};

std::string_view Ldlt::name() const { return "LDLᵀ (CHOLMOD)"; }

#else

struct Ldlt::Parts {
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
  std::optional<CompressedColumns> columns;
  Eigen::SimplicialLDLT<Sparse, Eigen::Upper> factor;

  Eigen::Map<const Sparse> view() {
    return {columns->columns(),    columns->columns(),     columns->entries(), columns->column_start().data(),
            columns->row().data(), columns->value().data()};
  }
  void analyse() { factor.analyzePattern(view()); }
  std::optional<int> factorise() {
    factor.factorize(view());
    if (factor.info() != Eigen::Success) return {};
    int negative = 0;
    for (const double pivot : factor.vectorD())
      if (!count(pivot, negative)) return {};
    return negative;
  }
  bool solve(ConstVectorRef b, VectorRef solution) {
    solution = factor.solve(b);
    return factor.info() == Eigen::Success;
  }
};

std::string_view Ldlt::name() const { return "LDLᵀ (Eigen)"; }

#endif

Ldlt::Ldlt() : parts_(std::make_unique<Parts>()) {}
Ldlt::~Ldlt() = default;

void Ldlt::analyse(const BlockStructure& structure) {
  negative_pivots_.reset();
  parts_->columns.emplace(structure, CompressedColumns::Part::upper_triangle);
  parts_->analyse();
}

FactorStatus Ldlt::factor(const BlockMatrix& matrix) {
  if (!parts_->columns) analyse(matrix.structure());
  parts_->columns->copy(matrix);
  matrix_ = &matrix;
  largest_entry_ = 0;
  for (const double value : parts_->columns->value()) largest_entry_ = std::max(largest_entry_, std::abs(value));
  negative_pivots_ = parts_->factorise();
  return negative_pivots_ ? FactorStatus::ok : FactorStatus::singular;
}

SolveReport Ldlt::solve(ConstVectorRef b, VectorRef x, double tolerance, double /*largest*/) {
  if (!negative_pivots_) return {false, 0, "LDLᵀ: the last matrix could not be factored"};
  const double enough = std::max(tolerance, 1e-13) * b.norm();
  Vector correction = Vector::Zero(b.size()), product(b.size()), rest = b;
  x.setZero();
  double previous = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= most_refinements; ++k) {
    if (!parts_->solve(rest, correction)) return {false, 0, "LDLᵀ: the triangular solves failed"};
    x += correction;
    if (!x.allFinite()) return {false, 0, "LDLᵀ: the solution is not finite"};
    if (matrix_->symmetry() == Symmetry::unsymmetric) return {};  // what it solves is not that matrix
    matrix_->multiply(x, product);
    rest = b - product;
    const double size = rest.norm();
    if (size <= enough || size > 0.5 * previous) break;
    previous = size;
  }
  if (rest.norm() <= largest_backward_error * (b.norm() + largest_entry_ * x.norm())) return {};
  return {false, 0, "LDLᵀ: its factor without pivoting is no good for this matrix"};
}

std::optional<int> negative_eigenvalues(const BlockMatrix& matrix) {
  Ldlt ldlt;
  return ldlt.factor(matrix) == FactorStatus::ok ? ldlt.negative_pivots() : std::nullopt;
}

}  // namespace sundrape

#include "symmetric_factor.hpp"

#include <algorithm>
#include <cmath>

#ifdef SUNDRAPE_WITH_CHOLMOD
#include "cholmod_handles.hpp"
#else
#include <Eigen/SparseCholesky>
#endif

namespace sundrape {
namespace {

/// Counts one pivot; false where it tells nothing.
bool count(double pivot, int& negative) {
  if (pivot < 0) ++negative;
  return pivot != 0 && std::isfinite(pivot);
}

}  // namespace

#ifdef SUNDRAPE_WITH_CHOLMOD

struct SymmetricFactor::Parts {
  Kind kind;
  cholmod::Common common;
  cholmod::Factor factor{nullptr, {&common}};
  cholmod_dense* x = nullptr;  // workspaces of the solve, kept by CHOLMOD between calls
  cholmod_dense* y = nullptr;
  cholmod_dense* e = nullptr;

  explicit Parts(Kind kind_of_factor) : kind(kind_of_factor) {
    const bool definite = kind == Kind::definite;
    common->supernodal = definite ? CHOLMOD_AUTO : CHOLMOD_SIMPLICIAL;
    common->final_ll =
        definite ? 1 : 0;  // also where CHOLMOD prefers simplicial, so that it notices an indefinite matrix
    common->quick_return_if_not_posdef = definite ? 1 : 0;
  }
  ~Parts() {
    for (auto** workspace : {&x, &y, &e}) cholmod_l_free_dense(workspace, common.get());
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void analyse(CompressedColumns& columns) { factor = cholmod::analyse(columns, common); }

  FactorStatus factorise(CompressedColumns& columns, int& negative) {
    if (!cholmod::factorise(columns, *factor, common))
      return common->status == CHOLMOD_NOT_POSDEF && kind == Kind::definite ? FactorStatus::not_positive_definite
                                                                            : FactorStatus::singular;
    if (kind == Kind::definite) return FactorStatus::ok;
    // The simplicial factor keeps D as the first entry of each column of L.
    const auto* start = static_cast<const SuiteSparse_long*>(factor->p);
    const auto* value = static_cast<const double*>(factor->x);
    for (std::size_t column = 0; column < factor->n; ++column)
      if (!count(value[start[column]], negative)) return FactorStatus::singular;
    return FactorStatus::ok;
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

#else

struct SymmetricFactor::Parts {
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
  Kind kind;
  Eigen::SimplicialLDLT<Sparse, Eigen::Upper> factor;

  explicit Parts(Kind kind_of_factor) : kind(kind_of_factor) {}

  static Eigen::Map<const Sparse> view(CompressedColumns& columns) {
    return {columns.columns(),    columns.columns(),     columns.entries(), columns.column_start().data(),
            columns.row().data(), columns.value().data()};
  }
  void analyse(CompressedColumns& columns) { factor.analyzePattern(view(columns)); }
  FactorStatus factorise(CompressedColumns& columns, int& negative) {
    factor.factorize(view(columns));
    if (factor.info() != Eigen::Success) return FactorStatus::singular;
    if (kind == Kind::definite)
      return (factor.vectorD().array() > 0).all() ? FactorStatus::ok : FactorStatus::not_positive_definite;
    for (const double pivot : factor.vectorD())
      if (!count(pivot, negative)) return FactorStatus::singular;
    return FactorStatus::ok;
  }
  bool solve(ConstVectorRef b, VectorRef solution) {
    solution = factor.solve(b);
    return factor.info() == Eigen::Success;
  }
};

#endif

SymmetricFactor::SymmetricFactor(Kind kind) : parts_(std::make_unique<Parts>(kind)) {}
SymmetricFactor::~SymmetricFactor() = default;

void SymmetricFactor::analyse(const BlockStructure& structure) {
  negative_pivots_.reset();
  columns_.emplace(structure, CompressedColumns::Part::upper_triangle);
  parts_->analyse(*columns_);
}

FactorStatus SymmetricFactor::factor(const BlockMatrix& matrix) {
  negative_pivots_.reset();
  if (!columns_) analyse(matrix.structure());
  columns_->copy(matrix);
  int negative = 0;
  const auto status = parts_->factorise(*columns_, negative);
  if (status == FactorStatus::ok) negative_pivots_ = negative;
  return status;
}

bool SymmetricFactor::solve(ConstVectorRef b, VectorRef x) { return negative_pivots_ && parts_->solve(b, x); }

double SymmetricFactor::largest_entry() {
  double largest = 0;
  for (const double value : columns_->value()) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace sundrape

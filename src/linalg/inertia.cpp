#include "sundrape/linalg/inertia.hpp"

#include <cmath>

#include "sundrape/linalg/compressed_columns.hpp"

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

struct Inertia::Parts {
  cholmod::Common common;
  CompressedColumns columns;
  cholmod::Factor factor{nullptr, {&common}};

  explicit Parts(const BlockStructure& structure) : columns(structure, CompressedColumns::Part::upper_triangle) {
    common->supernodal = CHOLMOD_SIMPLICIAL;
    common->final_ll = 0;
    factor = cholmod::analyse(columns, common);
  }

  std::optional<int> negative_eigenvalues() {
    if (!cholmod::factorise(columns, *factor, common)) return {};
    // The simplicial factor keeps D as the first entry of each column of L.
    const auto* start = static_cast<const SuiteSparse_long*>(factor->p);
    const auto* value = static_cast<const double*>(factor->x);
    int negative = 0;
    for (std::size_t column = 0; column < factor->n; ++column)
      if (!count(value[start[column]], negative)) return {};
    return negative;
  }
};

#else

struct Inertia::Parts {
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
  CompressedColumns columns;
  Eigen::SimplicialLDLT<Sparse, Eigen::Upper> factor;

  explicit Parts(const BlockStructure& structure) : columns(structure, CompressedColumns::Part::upper_triangle) {
    factor.analyzePattern(view());
  }
  Eigen::Map<const Sparse> view() {
    return {columns.columns(),    columns.columns(),     columns.entries(), columns.column_start().data(),
            columns.row().data(), columns.value().data()};
  }
  std::optional<int> negative_eigenvalues() {
    factor.factorize(view());
    if (factor.info() != Eigen::Success) return {};
    int negative = 0;
    for (const double pivot : factor.vectorD())
      if (!count(pivot, negative)) return {};
    return negative;
  }
};

#endif

Inertia::Inertia(const BlockStructure& structure) : parts_(std::make_unique<Parts>(structure)) {}
Inertia::~Inertia() = default;

std::optional<int> Inertia::negative_eigenvalues(const BlockMatrix& matrix) {
  parts_->columns.copy(matrix);
  return parts_->negative_eigenvalues();
}

std::optional<int> negative_eigenvalues(const BlockMatrix& matrix) {
  return Inertia(matrix.structure()).negative_eigenvalues(matrix);
}

}  // namespace sundrape

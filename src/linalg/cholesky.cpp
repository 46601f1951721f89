#include "sundrape/linalg/cholesky.hpp"

#include <stdexcept>

#include "sundrape/linalg/compressed_columns.hpp"

#ifdef SUNDRAPE_WITH_CHOLMOD
#include "cholmod_handles.hpp"
#else
#include <Eigen/SparseCholesky>
#endif

namespace sundrape {

#ifdef SUNDRAPE_WITH_CHOLMOD

struct Cholesky::Parts {
  cholmod::Common common;
  std::optional<CompressedColumns> columns;
  cholmod::Factor factor{nullptr, {&common}};
  cholmod_dense* x = nullptr;  // workspaces of the solve, kept by CHOLMOD between calls
  cholmod_dense* y = nullptr;
  cholmod_dense* e = nullptr;

  Parts() {
    common->supernodal = CHOLMOD_AUTO;
    common->final_ll = 1;  // L Lᵀ also where CHOLMOD prefers simplicial, so that it notices an indefinite matrix
    common->quick_return_if_not_posdef = 1;
  }
  ~Parts() {
    for (auto** workspace : {&x, &y, &e}) cholmod_l_free_dense(workspace, common.get());
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void analyse() { factor = cholmod::analyse(*columns, common); }

  FactorStatus factorise() {
    if (cholmod::factorise(*columns, *factor, common)) return FactorStatus::ok;
    return common->status == CHOLMOD_NOT_POSDEF ? FactorStatus::not_positive_definite : FactorStatus::singular;
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

std::string_view Cholesky::name() const { return "Cholesky (CHOLMOD)"; }

#else

struct Cholesky::Parts {
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
  std::optional<CompressedColumns> columns;
  Eigen::SimplicialLDLT<Sparse, Eigen::Upper> factor;

  Eigen::Map<const Sparse> view() {
    return {columns->columns(),    columns->columns(),     columns->entries(), columns->column_start().data(),
            columns->row().data(), columns->value().data()};
  }
  void analyse() { factor.analyzePattern(view()); }
  FactorStatus factorise() {
    factor.factorize(view());
    if (factor.info() != Eigen::Success) return FactorStatus::singular;
    return (factor.vectorD().array() > 0).all() ? FactorStatus::ok : FactorStatus::not_positive_definite;
  }
  bool solve(ConstVectorRef b, VectorRef solution) {
    solution = factor.solve(b);
    return factor.info() == Eigen::Success;
  }
};

std::string_view Cholesky::name() const { return "Cholesky (Eigen)"; }

#endif

Cholesky::Cholesky() : parts_(std::make_unique<Parts>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::analyse(const BlockStructure& structure) {
  factored_ = false;
  parts_->columns.emplace(structure, CompressedColumns::Part::upper_triangle);
  parts_->analyse();
}

FactorStatus Cholesky::factor(const BlockMatrix& matrix) {
  factored_ = false;
  if (matrix.symmetry() != Symmetry::symmetric) throw std::invalid_argument("Cholesky wants a symmetric matrix");
  if (!parts_->columns) analyse(matrix.structure());
  parts_->columns->copy(matrix);
  const auto status = parts_->factorise();
  factored_ = status == FactorStatus::ok;
  return status;
}

SolveReport Cholesky::solve(ConstVectorRef b, VectorRef x, double /*tolerance*/, double /*largest*/) {
  if (!factored_) return {.ok = false, .problem = "Cholesky: the last matrix could not be factored"};
  if (!parts_->solve(b, x)) return {.ok = false, .problem = "Cholesky: the triangular solves failed"};
  if (!x.allFinite()) return {.ok = false, .problem = "Cholesky: the solution is not finite"};
  return {};
}

std::optional<int> Cholesky::negative_pivots() const { return factored_ ? std::optional(0) : std::nullopt; }

}  // namespace sundrape

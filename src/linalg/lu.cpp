#include "sundrape/linalg/lu.hpp"

#include <limits>
#include <stdexcept>

#include <klu.h>

#include "sundrape/linalg/compressed_columns.hpp"

namespace sundrape {
namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t), "KLU's long interface has 64-bit indices");

// Entries of the factors that outgrow the matrix by more than this cost digits: choose new pivots.
constexpr double least_reciprocal_growth = 1e-6;
constexpr double least_reciprocal_condition = std::numeric_limits<double>::epsilon();

struct SymbolicDeleter {
  klu_l_common* common;
  void operator()(klu_l_symbolic* symbolic) const { klu_l_free_symbolic(&symbolic, common); }
};
struct NumericDeleter {
  klu_l_common* common;
  void operator()(klu_l_numeric* numeric) const { klu_l_free_numeric(&numeric, common); }
};

}  // namespace

struct Lu::Parts {
  klu_l_common common{};
  std::optional<CompressedColumns> columns;
  std::unique_ptr<klu_l_symbolic, SymbolicDeleter> symbolic{nullptr, {&common}};
  std::unique_ptr<klu_l_numeric, NumericDeleter> numeric{nullptr, {&common}};

  Parts() {
    klu_l_defaults(&common);
    common.ordering = 0;  // AMD
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  SuiteSparse_long* start() { return reinterpret_cast<SuiteSparse_long*>(columns->column_start().data()); }
  SuiteSparse_long* row() { return reinterpret_cast<SuiteSparse_long*>(columns->row().data()); }
  double* value() { return columns->value().data(); }

  void analyse() {
    numeric.reset();
    symbolic.reset(klu_l_analyze(columns->columns(), start(), row(), &common));
    if (!symbolic) throw std::runtime_error("KLU could not analyse the matrix");
  }

  bool old_pivots_serve() {
    return numeric && klu_l_refactor(start(), row(), value(), symbolic.get(), numeric.get(), &common) != 0 &&
           klu_l_rgrowth(start(), row(), value(), symbolic.get(), numeric.get(), &common) != 0 &&
           common.rgrowth > least_reciprocal_growth && regular();
  }

  FactorStatus factorise() {
    if (old_pivots_serve()) return FactorStatus::ok;
    numeric.reset(klu_l_factor(start(), row(), value(), symbolic.get(), &common));
    if (numeric && regular()) return FactorStatus::ok;
    numeric.reset();
    return FactorStatus::singular;
  }

  /// False also where the condition number is not a number.
  bool regular() {
    return klu_l_rcond(symbolic.get(), numeric.get(), &common) != 0 && common.rcond > least_reciprocal_condition;
  }
};

Lu::Lu() : parts_(std::make_unique<Parts>()) {}
Lu::~Lu() = default;

void Lu::analyse(const BlockStructure& structure) {
  factored_ = false;
  parts_->columns.emplace(structure, CompressedColumns::Part::whole);
  parts_->analyse();
}

FactorStatus Lu::factor(const BlockMatrix& matrix) {
  factored_ = false;
  if (!parts_->columns) analyse(matrix.structure());
  parts_->columns->copy(matrix);
  const auto status = parts_->factorise();
  factored_ = status == FactorStatus::ok;
  return status;
}

SolveReport Lu::solve(ConstVectorRef b, VectorRef x, double /*tolerance*/, double /*largest*/) {
  if (!factored_) return {.ok = false, .problem = "LU: the last matrix could not be factored"};
  x = b;
  if (klu_l_solve(parts_->symbolic.get(), parts_->numeric.get(), b.size(), 1, x.data(), &parts_->common) == 0)
    return {.ok = false, .problem = "LU: the triangular solves failed"};
  if (!x.allFinite()) return {.ok = false, .problem = "LU: the solution is not finite"};
  return {};
}

}  // namespace sundrape

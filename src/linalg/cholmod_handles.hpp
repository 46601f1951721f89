#pragma once
#include <cstdint>
#include <memory>

#include <cholmod.h>

#include "sundrape/linalg/compressed_columns.hpp"

namespace sundrape::cholmod {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t), "CHOLMOD's long interface has 64-bit indices");

/// CHOLMOD's settings and workspace: AMD ordering, silent, 64-bit indices.
class Common {
 public:
  Common();
  ~Common() { cholmod_l_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;

  [[nodiscard]] cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

 private:
  cholmod_common common_{};
};

struct FactorDeleter {
  Common* common;
  void operator()(cholmod_factor* factor) const { cholmod_l_free_factor(&factor, common->get()); }
};
using Factor = std::unique_ptr<cholmod_factor, FactorDeleter>;

/// Keeps OpenMP's threads out of CHOLMOD while it lives: at the size of a cloth they cost more than they bring.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_before_;
};

/// CHOLMOD's view of an upper triangle; valid as long as `columns` lives.
[[nodiscard]] cholmod_sparse symmetric_view(CompressedColumns& columns);

/// CHOLMOD's view of a vector of doubles.
[[nodiscard]] cholmod_dense vector_view(double* values, std::int64_t size);

/// Numerical factorisation; false where CHOLMOD failed or met a pivot that its kind of factor does not allow.
[[nodiscard]] bool factorise(CompressedColumns& columns, cholmod_factor& factor, Common& common);

/// Symbolic analysis.  @throws std::runtime_error  out of memory
[[nodiscard]] Factor analyse(CompressedColumns& columns, Common& common);

}  // namespace sundrape::cholmod

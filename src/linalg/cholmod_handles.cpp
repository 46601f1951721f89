#ifdef SUNDRAPE_WITH_CHOLMOD
#include "cholmod_handles.hpp"

#include <stdexcept>

#include <omp.h>

// Present only when the BLAS that was linked is OpenBLAS.
extern "C" [[gnu::weak]] void openblas_set_num_threads(int);

namespace sundrape::cholmod {

Common::Common() {
  // The supernodes of a cloth are too small for threads: OpenBLAS would only spin.
  static const bool single_threaded_blas = [] {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    return true;
  }();
  (void)single_threaded_blas;
  cholmod_l_start(&common_);
  common_.print = 0;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_AMD;
  common_.postorder = 1;
}

OneThread::OneThread() : levels_before_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
OneThread::~OneThread() { omp_set_max_active_levels(levels_before_); }

cholmod_sparse symmetric_view(CompressedColumns& columns) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(columns.columns());
  view.nzmax = static_cast<std::size_t>(columns.entries());
  view.p = columns.column_start().data();
  view.i = columns.row().data();
  view.x = columns.value().data();
  view.stype = 1;
  view.itype = CHOLMOD_LONG;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

cholmod_dense vector_view(double* values, std::int64_t size) {
  cholmod_dense view{};
  view.nrow = view.nzmax = view.d = static_cast<std::size_t>(size);
  view.ncol = 1;
  view.x = values;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

Factor analyse(CompressedColumns& columns, Common& common) {
  auto view = symmetric_view(columns);
  Factor factor(cholmod_l_analyze(&view, common.get()), FactorDeleter{&common});
  if (!factor) throw std::runtime_error("CHOLMOD could not analyse the matrix: out of memory");
  return factor;
}

bool factorise(CompressedColumns& columns, cholmod_factor& factor, Common& common) {
  const OneThread guard;
  auto view = symmetric_view(columns);
  return cholmod_l_factorize(&view, &factor, common.get()) != 0 && common->status == CHOLMOD_OK;
}

}  // namespace sundrape::cholmod
#endif

#include "support/full_size_matrix.hpp"

namespace sundrape {

FullSizeMatrix::FullSizeMatrix(const System& system)
    : system_(system),
      stiffness_(system.structure(), Symmetry::unsymmetric),
      damping_(system.structure(), Symmetry::unsymmetric),
      stiffness_columns_(system.structure(), CompressedColumns::Part::whole),
      damping_columns_(system.structure(), CompressedColumns::Part::whole) {
  const auto half = stiffness_columns_.columns();
  const auto& start = stiffness_columns_.column_start();
  const auto& row = stiffness_columns_.row();
  column_start_.push_back(0);
  for (std::int64_t column = 0; column < 2 * half; ++column) {
    const auto j = static_cast<std::size_t>(column % half);
    row_.push_back(column % half);
    for (auto k = start[j]; k < start[j + 1]; ++k) row_.push_back(half + row[static_cast<std::size_t>(k)]);
    column_start_.push_back(static_cast<std::int64_t>(row_.size()));
  }
  value_.resize(row_.size());
}

void FullSizeMatrix::assemble(const State& all) {
  stiffness_.set_zero();
  damping_.set_zero();
  system_.add_tangent(all, -1, 0, stiffness_);
  system_.add_tangent(all, 0, -1, damping_);
  system_.hold(stiffness_, 0);
  system_.hold(damping_, 0);
}

void FullSizeMatrix::fill_newton(double c) {
  damping_.add_diagonal(system_.row_mass(), c);
  fill(c, -1, Vector::Ones(system_.row_mass().size()));
  damping_.add_diagonal(system_.row_mass(), -c);
}

void FullSizeMatrix::fill_jacobian() { fill(0, 1, -system_.row_mass().cwiseInverse()); }

void FullSizeMatrix::fill(double left, double right, ConstVectorRef scale) {
  stiffness_columns_.copy(stiffness_);
  damping_columns_.copy(damping_);
  std::size_t to = 0;
  const auto fill_half = [&](double above, CompressedColumns& below) {
    std::int64_t from = 0;
    for (std::size_t j = 0; j < static_cast<std::size_t>(below.columns()); ++j) {
      value_[to++] = above;
      for (; from < below.column_start()[j + 1]; ++from) {
        const auto k = static_cast<std::size_t>(from);
        value_[to++] = scale[below.row()[k] / 3] * below.value()[k];
      }
    }
  };
  fill_half(left, stiffness_columns_);
  fill_half(right, damping_columns_);
}

}  // namespace sundrape

#pragma once
#include <cstddef>
#include <type_traits>

#include <Eigen/Core>

#include "sundrape/linalg/padded_matrix.hpp"

namespace sundrape {

/// work(std::integral_constant<std::size_t, m>()) for m = 1 to PaddedMatrix::together vectors, known only when it runs.
template <class Work>
auto side_by_side(Eigen::Index m, Work&& work) {
  static_assert(PaddedMatrix::together == 4);
  switch (m) {
    case 1:
      return work(std::integral_constant<std::size_t, 1>());
    case 2:
      return work(std::integral_constant<std::size_t, 2>());
    case 3:
      return work(std::integral_constant<std::size_t, 3>());
    default:
      return work(std::integral_constant<std::size_t, 4>());
  }
}

}  // namespace sundrape

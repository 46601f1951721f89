#pragma once
#include <stdexcept>

#include <arkode/arkode_butcher_dirk.h>

namespace sundrape {

struct DirkTable {
  int order;
  ARKODE_DIRKTableID id;
};

/// The method of an order, all of them L-stable, stiffly accurate and of stage order 2, with an explicit first stage
/// and the same γ in all others (docs/integrators.md).
/// @throws std::invalid_argument  an order outside [2, 5]
[[nodiscard]] inline DirkTable dirk_table(int order) {
  switch (order) {
    case 2:
      return {2, ARKODE_TRBDF2_3_3_2};
    case 3:
      return {3, ARKODE_ESDIRK325L2SA_5_2_3};
    case 4:
      return {4, ARKODE_ESDIRK436L2SA_6_3_4};
    case 5:
      return {5, ARKODE_ESDIRK547L2SA2_7_4_5};
    default:
      throw std::invalid_argument("diagonally implicit Runge–Kutta methods are of order 2 to 5");
  }
}

}  // namespace sundrape

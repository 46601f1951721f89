#pragma once
#include "sundrape/linalg/block_matrix.hpp"

namespace sundrape {

/// Largest eigenvalue of M⁻¹A, M diagonal with one entry a block row, by power iteration from a fixed random start.
/// An underestimate, by about a percent after the 200 iterations that it takes.
[[nodiscard]] double largest_eigenvalue(const BlockMatrix& a, const Vector& row_mass);

}  // namespace sundrape

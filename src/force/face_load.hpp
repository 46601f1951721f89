#pragma once
#include <array>

#include <Eigen/Geometry>

#include "sundrape/linalg/block_matrix.hpp"
#include "sundrape/types.hpp"

namespace sundrape {

/// The diagonals of a face, between its nodes 0 and 2, and 1 and 3; half their product is its area vector.
struct FaceDiagonals {
  Vector3 first, second;  // [m]

  FaceDiagonals(const std::array<int, 4>& nodes, const ConstVectorRef& q)
      : first(point(q, nodes[2]) - point(q, nodes[0])), second(point(q, nodes[3]) - point(q, nodes[1])) {}

  [[nodiscard]] Vector3 area() const { return 0.5 * first.cross(second); }  // [m²]
};

/// Adds the tangent of a force that each of a face's nodes carries alike: block (p, q) depends on q alone.
/// @param by_node  derivative of one node's force by what moves node q
inline void add_shared_tangent(const std::array<Matrix3, 4>& by_node, std::size_t face, Assembler& tangent) {
  for (int q = 0; q < 4; ++q) {
    const Matrix3& column = by_node[static_cast<std::size_t>(q)];
    tangent.add_diagonal(face, q, tangent.keeps_unsymmetric() ? column : Matrix3(0.5 * (column + column.transpose())));
    for (int p = 0; p < q; ++p) tangent.add_general_pair(face, p, q, column, by_node[static_cast<std::size_t>(p)]);
  }
}

/// By the diagonals' derivatives: node 0 begins the first one and node 2 ends it, 1 and 3 the second.
inline std::array<Matrix3, 4> by_nodes(const Matrix3& by_first, const Matrix3& by_second) {
  return {-by_first, -by_second, by_first, by_second};
}

}  // namespace sundrape

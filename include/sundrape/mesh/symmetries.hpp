#pragma once
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// A rotation or reflection that maps a rest shape onto itself, node to node and quad to quad.
///
/// R (X_i − c) + c = X_π(i) with c the mean of the nodes. Where a shape is flat, each π comes with two R, one of which
/// turns the sheet's other side up.
struct MeshSymmetry {
  Matrix3 rotation = Matrix3::Identity();  // R, orthogonal; a reflection where its determinant is −1
  std::vector<int> image;                  // π, N
};

/// Every symmetry of a rest shape, the identity first, then in an order that the mesh alone decides.
///
/// Two nodes that stand out by how few others are as far from the centre, and the centre, fix an isometry up to the
/// reflection at their plane; so all isometries are found by trying all images of these two, whatever the shape: the 16
/// of a square, the 8 of a rectangle, 4n of an annulus with n cells around.
/// @param tolerance  by how much an image may miss its node, over the diagonal
/// @throws std::invalid_argument  all nodes on one line through the centre: every turn about it would do
[[nodiscard]] std::vector<MeshSymmetry> mesh_symmetries(const QuadMesh& mesh, double tolerance = 1e-6);

/// Mean of the nodes' rest positions [m].
[[nodiscard]] Vector3 centre_of_nodes(const QuadMesh& mesh);

}  // namespace sundrape

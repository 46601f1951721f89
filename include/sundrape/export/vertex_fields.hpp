#pragma once
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"
#include "sundrape/types.hpp"

/// Fields on the nodes of a deformed sheet, made of its shape alone, for programs that draw it.
namespace sundrape {

/// Which of a quad's lengths its membrane strain is made of.
enum class StrainOf {
  sides_and_diagonals,  // the springs of a net's cell: opposite sides averaged
  centre                // of a shell's element
};

/// Largest principal stretch less 1 at each node, N: of the quads at it, averaged by their areas at rest.
[[nodiscard]] Vector principal_strains(const QuadMesh& mesh, const std::vector<Vector3>& positions, StrainOf kind);

/// The larger size of the two principal curvatures at each node [1/m], N: of the quads at it, from the turn of the
/// nodes' normals, averaged by areas at rest.
/// @param normals  N, unit
[[nodiscard]] Vector principal_curvatures(const QuadMesh& mesh, const std::vector<Vector3>& positions,
                                          const std::vector<Vector3>& normals);

}  // namespace sundrape

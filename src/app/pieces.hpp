#pragma once
#include <vector>

#include "sundrape/io/case.hpp"
#include "sundrape/mesh/joined.hpp"

namespace sundrape {

/// The cloth of a case before anything happens to it.
///
/// A single sheet is as its builder made it, and placed; of several the rest shapes are where they are placed, so that
/// they do not lie in each other.
struct Cloth {
  QuadMesh mesh;
  std::vector<MeshPiece> pieces;
  RigidPlacement placement;      // from the rest shape to where it is placed
  std::vector<Vector3> placed;   // N [m]
  std::vector<Vector3> initial;  // placed and wavy, N [m]
  double size = 0;               // longest side of a piece's bounding box at rest [m]
  double diagonal = 0;           // of the largest of these boxes [m]
};

/// @throws CaseError  a mesh that cannot be used; a piece whose name is that of a node set
[[nodiscard]] Cloth build_cloth(const Case& c);

}  // namespace sundrape

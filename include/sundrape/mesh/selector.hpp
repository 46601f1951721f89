#pragma once
#include <string>
#include <variant>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// Ways to pick nodes; geometry is compared with the initial (placed) positions, all lengths in metres.

/// A named set of the mesh.
struct NamedSet {
  std::string name;
};
/// The closest node: all closest ones within 1e-9 of the mesh's diagonal.
struct Near {
  Vector3 point;
};
/// Nodes inside or on the surface, within 1e-9 of the diagonal.
struct InBox {
  Vector3 low, high;
};
/// Nodes within 1e-6 of the diagonal. The normal may have any length but 0.
struct OnPlane {
  Vector3 point, normal;
};
/// Nodes inside or on the surface, within 1e-9 of the diagonal.
struct InSphere {
  Vector3 centre;
  double radius;
};
using Selector = std::variant<NamedSet, Near, InBox, OnPlane, InSphere>;

/// Ascending node numbers. Empty if nothing fits: callers decide whether that is an error.
/// @throws std::invalid_argument  a set that the mesh does not have (the message lists those it has); a normal of zero
[[nodiscard]] std::vector<int> select(const Selector& selector, const QuadMesh& mesh,
                                      const std::vector<Vector3>& positions);

}  // namespace sundrape

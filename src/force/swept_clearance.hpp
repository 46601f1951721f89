#pragma once
#include <optional>

#include "sundrape/force/separation.hpp"

namespace sundrape {

/// Where two shapes meet, nearly, on their way.
struct Meeting {
  double share;                   // of the way, in [0, 1]
  std::array<double, 4> weights;  // of the points in the shortest way then
};

/// Whether two shapes whose points go straight from one place to another come nearer than `clearance` [m], which they
/// are not at the start unless they part: conservative advancement by how far no point can have come (M. Li et al.,
/// "Codimensional incremental potential contact", 2021, algorithm 1). Nothing if they keep their distance.
[[nodiscard]] std::optional<Meeting> first_contact(Shapes shapes, const std::array<Vector3, 4>& from,
                                                   const std::array<Vector3, 4>& to, double clearance);

}  // namespace sundrape

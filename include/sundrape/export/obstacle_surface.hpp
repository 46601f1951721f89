#pragma once
#include <array>
#include <vector>

#include "sundrape/io/result.hpp"
#include "sundrape/types.hpp"

namespace sundrape {

/// Triangles with a normal at each vertex; a vertex on a sharp edge is there once for each side.
struct ShadedSurface {
  std::vector<Vector3> vertices;              // [m]
  std::vector<Vector3> normals;               // unit, outwards
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise from outside
};

/// Where an infinite plane is drawn: a square about the foot of a point.
struct PlanePatch {
  Vector3 about;  // in the obstacle's own frame [m]
  double half;    // half its side [m]
};

/// The surface of an obstacle in its own frame, round parts in facets of at most 3.75°.
/// @throws FileError  a kind that this version does not know, or a parameter that is missing
[[nodiscard]] ShadedSurface obstacle_surface(const ObstacleRecord& obstacle, const PlanePatch& patch);

}  // namespace sundrape

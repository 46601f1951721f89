#pragma once
#include "sundrape/mesh/triangle_mesh.hpp"

namespace sundrape {

/// Twelve triangles about the origin; vertex 1·[x > 0] + 2·[y > 0] + 4·[z > 0].
[[nodiscard]] TriangleMesh box_mesh(const Vector3& size);

/// An icosahedron whose edges are halved, on a sphere about the origin: 20 · 4^halvings triangles.
///
/// Facets are largest at the middles of the icosahedron's faces, which the sphere is 1/0.795 times as far out as: their
/// circumradius there is 0.607/0.795 = 0.764 radius / 2^halvings, so they come within 0.764²/2 = 0.292 radius /
/// 4^halvings of the sphere.
[[nodiscard]] TriangleMesh ball_mesh(double radius, int halvings);

/// A ring around the z axis: `around` pieces along it, `across` along its section.
[[nodiscard]] TriangleMesh torus_mesh(double radius, double section_radius, int around, int across);

/// The same surface with all triangles facing the other way.
[[nodiscard]] TriangleMesh turned_over(TriangleMesh mesh);

}  // namespace sundrape

#pragma once
#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// Flat sheets in the plane z = 0, centred at the origin; normals along +z; material coordinates are x (warp) and y
/// (weft). Every one has the sets "all" and "boundary".

/// A rectangle of cells_warp × cells_weft equal cells; node iy (cells_warp + 1) + ix stands ix cells along x, iy along
/// y.
///
/// Sets: "left" (smallest x), "right", "bottom" (smallest y), "top", and the corners "bottom_left", "bottom_right",
/// "top_left", "top_right".
/// @param length, width  along warp and weft [m]
/// @throws std::invalid_argument  unless length, width > 0 and both cell counts ≥ 1
[[nodiscard]] QuadMesh rectangle(double length, double width, int cells_warp, int cells_weft);

/// A disc: a square core with bulging sides, joined to the circle by rings of cells; boundary nodes lie on the circle.
///
/// A single square grid bent onto a disc needs four corner cells with an angle of nearly 180°; the core avoids them at
/// the price of four inner nodes with three cells. Angles stay within 56° … 128°, the sides of a
/// cell within 1 : 2 (from four cells; from ten 56° … 123° and 1 : 1.7).
/// Sets: "centre", one node if `cells` is even, the four around the centre if it is odd.
/// @param radius  [m]
/// @param cells   across the diameter, ≥ 3
/// @throws std::invalid_argument  out of range
[[nodiscard]] QuadMesh disc(double radius, int cells);

/// A ring of cells_radial × cells_around cells; node ir cells_around + ia stands ir cells outward, ia counter-clockwise
/// from the x axis. Sets: "inner", "outer".
/// @param inner, outer  radii [m]
/// @throws std::invalid_argument  unless 0 < inner < outer, cells_radial ≥ 1 and cells_around ≥ 3
[[nodiscard]] QuadMesh annulus(double inner, double outer, int cells_radial, int cells_around);

}  // namespace sundrape

#pragma once
#include <utility>
#include <vector>

#include "sundrape/mesh/sheet_surface.hpp"

namespace sundrape {

/// The pairs of triangles of a surface that have points in common without sharing a node, ascending.
///
/// Exact: coordinates are taken for the numbers that they are, and no rounding decides (Guigue, Devillers 2003, on
/// exact predicates; CGAL).
/// @param q  3N or more, the nodes first; pairs with nodes that are not finite are left out
[[nodiscard]] std::vector<std::pair<int, int>> crossings(const SheetSurface& surface, ConstVectorRef q);

}  // namespace sundrape

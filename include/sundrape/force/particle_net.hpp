#pragma once
#include <memory>
#include <vector>

#include "sundrape/force/edge_moment.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/material/fabric.hpp"
#include "sundrape/mesh/threads.hpp"

namespace sundrape {

/// The particle net of a sheet (chapter §3.1): stretch along threads, in-plane shear along diagonals, bending between
/// consecutive edges of a thread, clamped slopes. Every spring stands for its tributary width of cloth, so a finer net
/// converges to the same sheet and an edge on the boundary counts half. Where the fabric's bending was measured as
/// M = f(K), warp and weft bend in terms of their own, each by its law times the 1/(1 − ν²) of (45).
///
/// @param placed   positions of the nodes where the sheet was put, N [m]: clamps hold the slopes that it has there
/// @param clamped  nodes whose slopes are held, N entries
[[nodiscard]] std::vector<std::unique_ptr<ForceTerm>> particle_net(const QuadMesh& mesh, const Threads& threads,
                                                                   const Fabric& fabric,
                                                                   const std::vector<Vector3>& placed,
                                                                   const std::vector<bool>& clamped);

/// Lumped masses: area density times tributary area, N [kg].
[[nodiscard]] Vector lumped_mass(const QuadMesh& mesh, const Fabric& fabric);

/// A moment [N m] on the threads that end at `nodes`, shared by tributary length of the boundary between them.
/// @throws std::invalid_argument  no boundary edge between the nodes, or no thread that ends there
[[nodiscard]] std::vector<LoadedEdge> moment_on_edge(const QuadMesh& mesh, const Threads& threads,
                                                     const std::vector<int>& nodes, const Vector3& total);

}  // namespace sundrape

#pragma once
#include <span>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// One piece of thread: an edge of the mesh.
struct Segment {
  int i, j;       // end nodes
  double length;  // at rest [m]
  double width;   // tributary width of cloth that the thread stands for [m]: b inside a grid of spacing b, b/2 on its
                  // boundary
  bool warp;  // closer to warp than to weft in material coordinates; at 45° the diagonal (1, 1) is, (−1, 1) is not
};

/// A thread line passing a node, and the crossing thread that spans the tangent plane with it.
///
/// With t = x[next] − x[previous] and c = x[cross_to] − x[cross_from] − skew · t, c ⊥ t at rest, and t × c points along
/// the normal of the quads.
struct Bend {
  int previous, centre, next;  // nodes along the thread
  int cross_from, cross_to;  // both neighbours on the crossing thread; at a boundary the centre and the inner neighbour
  double skew;               // λ
  double length;             // half the sum of the two edges [m]
  double width;              // mean of the two segments' widths, weighted by their lengths [m]
  bool warp;                 // t is closer to warp than to weft
};

/// One thread leaving a node.
struct ThreadEnd {
  int neighbour;  // node at the segment's other end
  int through;    // neighbour on the other side of the node, where the thread goes on; −1 where it ends
  int segment;    // index of the segment
};

/// The thread topology of the particle net.
struct Threads {
  std::vector<Segment> segments;  // every edge once, i < j
  std::vector<Bend> bends;        // two at a node inside, one along a boundary, none at a corner
  std::vector<int> end_start;     // N + 1
  std::vector<ThreadEnd> ends;    // those of node n: end_start[n] … end_start[n + 1] − 1

  [[nodiscard]] std::span<const ThreadEnd> ends_at(int node) const {
    const auto n = static_cast<std::size_t>(node);
    return {ends.data() + end_start[n], ends.data() + end_start[n + 1]};
  }
};

/// Finds the threads of a sheet.
///
/// Each quad hands its area to its two pairs of opposite edges: A / (l + l') of width to each edge of a pair, so that
/// Σ length · width is the sheet's area once for each of the two directions. A thread goes on through a node with four
/// quads to the edge that shares no quad with it, and along the boundary through a node with two quads; at irregular
/// nodes (three or five quads) it ends.
/// @throws std::invalid_argument  a mesh that is not sound (require_sound); parts that hang together at one node alone
[[nodiscard]] Threads find_threads(const QuadMesh& mesh);

/// Those of the threads whose nodes lie in [first, last); the numbers of nodes stay.
[[nodiscard]] Threads threads_between(const Threads& threads, int first, int last);

}  // namespace sundrape

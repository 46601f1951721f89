#include "sundrape/mesh/threads.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sundrape/mesh/edges.hpp"

namespace sundrape {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// On the bias the two diagonals count as one of each, so that a sheet cut at 45° still has two families of threads.
bool closer_to_warp(const QuadMesh& mesh, int from, int to) {
  const Eigen::Vector2d along = mesh.material[index(to)] - mesh.material[index(from)];
  const double excess = std::abs(along.x()) - std::abs(along.y());
  if (std::abs(excess) <= 1e-9 * along.norm()) return along.x() * along.y() > 0;
  return excess > 0;
}

std::vector<Segment> segments_of(const QuadMesh& mesh, const EdgeTable& table) {
  std::vector<Segment> segments;
  segments.reserve(table.edges.size());
  for (const auto& edge : table.edges) {
    const double length = (mesh.reference[index(edge.j)] - mesh.reference[index(edge.i)]).norm();
    segments.push_back({edge.i, edge.j, length, 0.0, closer_to_warp(mesh, edge.i, edge.j)});
  }
  const auto areas = quad_areas(mesh);
  for (std::size_t e = 0; e < areas.size(); ++e)
    for (std::size_t k = 0; k < 2; ++k) {
      auto& first = segments[index(table.quad_edge[e][k])];
      auto& opposite = segments[index(table.quad_edge[e][k + 2])];
      const double width = areas[e] / (first.length + opposite.length);
      first.width += width;
      opposite.width += width;
    }
  return segments;
}

/// The corner of one quad at a node: counter-clockwise around the node it lies between two edges.
struct Corner {
  int from, to;                  // neighbours of the node on those edges
  int from_segment, to_segment;  // the edges
};

/// The edges at a node, counter-clockwise.
struct Fan {
  std::vector<int> neighbours, segments;
  bool closed;  // the quads surround the node
};

/// Orders the corners at a node.
Fan fan_of(int node, const std::vector<Corner>& corners) {
  const auto corner_with = [&](int neighbour, int Corner::*side) {
    for (const auto& c : corners)
      if (c.*side == neighbour) return &c;
    return static_cast<const Corner*>(nullptr);
  };
  const Corner* start = &corners.front();
  for (const auto& c : corners)
    if (!corner_with(c.from, &Corner::to)) start = &c;  // clockwise of it there is nothing: a boundary

  Fan fan{{start->from}, {start->from_segment}, false};
  std::size_t passed = 0;
  for (const Corner* c = start; c; c = corner_with(c->to, &Corner::from)) {
    ++passed;
    if (c->to == start->from) {
      fan.closed = true;
      break;
    }
    fan.neighbours.push_back(c->to);
    fan.segments.push_back(c->to_segment);
  }
  if (passed != corners.size())
    throw std::invalid_argument(fmt::format("parts of the sheet hang together at node {} alone", node));
  return fan;
}

std::vector<std::vector<Corner>> corners_at_nodes(const QuadMesh& mesh, const EdgeTable& table) {
  std::vector<std::vector<Corner>> corners(mesh.reference.size());
  for (std::size_t e = 0; e < mesh.quads.size(); ++e)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto &quad = mesh.quads[e], &edge = table.quad_edge[e];
      const std::size_t before = (k + 3) % 4;
      corners[index(quad[k])].push_back({quad[(k + 1) % 4], quad[before], edge[k], edge[before]});
    }
  return corners;
}

/// Thread k of a fan goes on through thread `through(k)`; −1 where it ends.
int through(const Fan& fan, int k) {
  const auto edges = static_cast<int>(fan.neighbours.size());
  if (fan.closed && edges == 4) return (k + 2) % 4;
  if (!fan.closed && edges == 3) return k == 1 ? -1 : 2 - k;
  return -1;
}

Bend make_bend(const QuadMesh& mesh, const std::vector<Segment>& segments, int centre, const Fan& fan, int k) {
  const auto ahead = index(k), behind = index(through(fan, k));
  // The crossing thread lies a quarter turn counter-clockwise of `next`; at a boundary it starts at the node itself.
  Bend bend{fan.neighbours[behind],
            centre,
            fan.neighbours[ahead],
            fan.closed ? fan.neighbours[(ahead + 3) % 4] : centre,
            fan.neighbours[ahead + 1],
            0,
            0,
            0,
            false};
  const auto& x = mesh.reference;
  const Vector3 along = x[index(bend.next)] - x[index(bend.previous)];
  const Vector3 across = x[index(bend.cross_to)] - x[index(bend.cross_from)];
  const auto &first = segments[index(fan.segments[behind])], &second = segments[index(fan.segments[ahead])];
  bend.skew = across.dot(along) / along.squaredNorm();
  bend.length = 0.5 * (first.length + second.length);
  bend.width = 0.5 * (first.length * first.width + second.length * second.width) / bend.length;
  bend.warp = closer_to_warp(mesh, bend.previous, bend.next);
  return bend;
}

}  // namespace

Threads find_threads(const QuadMesh& mesh) {
  require_sound(mesh);
  const auto table = edge_table(mesh);
  Threads threads;
  threads.segments = segments_of(mesh, table);
  threads.end_start.push_back(0);
  const auto corners = corners_at_nodes(mesh, table);
  for (int node = 0; node < mesh.nodes(); ++node) {
    const auto fan = fan_of(node, corners[index(node)]);
    for (int k = 0; k < static_cast<int>(fan.neighbours.size()); ++k) {
      const int partner = through(fan, k);
      threads.ends.push_back(
          {fan.neighbours[index(k)], partner < 0 ? -1 : fan.neighbours[index(partner)], fan.segments[index(k)]});
      if (partner > k) threads.bends.push_back(make_bend(mesh, threads.segments, node, fan, k));
    }
    threads.end_start.push_back(static_cast<int>(threads.ends.size()));
  }
  return threads;
}

Threads threads_between(const Threads& threads, int first, int last) {
  const auto inside = [&](int node) { return node >= first && node < last; };
  Threads part;
  std::vector<int> number_in_part;
  for (const auto& segment : threads.segments) {
    number_in_part.push_back(static_cast<int>(part.segments.size()));
    if (inside(segment.i)) part.segments.push_back(segment);
  }
  for (const auto& bend : threads.bends)
    if (inside(bend.centre)) part.bends.push_back(bend);
  part.end_start.push_back(0);
  for (int node = 0; node + 1 < static_cast<int>(threads.end_start.size()); ++node) {
    if (inside(node))
      for (auto end : threads.ends_at(node)) {
        end.segment = number_in_part[index(end.segment)];
        part.ends.push_back(end);
      }
    part.end_start.push_back(static_cast<int>(part.ends.size()));
  }
  return part;
}

}  // namespace sundrape

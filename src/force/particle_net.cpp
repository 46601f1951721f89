#include "sundrape/force/particle_net.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <stdexcept>

#include <Eigen/Geometry>

#include "sundrape/force/bend_springs.hpp"
#include "sundrape/force/cell_shear.hpp"
#include "sundrape/force/clamp_springs.hpp"
#include "sundrape/force/hinge_angle.hpp"
#include "sundrape/force/stretch_springs.hpp"

namespace sundrape {
namespace {

/// Bending of the threads along warp or weft.
struct ThreadBending {
  double rigidity;                     // B of the sheet [N m], of a measured law that at K = 0
  std::optional<MomentCurvature> law;  // none: linear
};

ThreadBending bending(const Fabric& fabric, bool warp) {
  if (!fabric.measured_bending) return {warp ? fabric.warp_bending : fabric.weft_bending, std::nullopt};
  const auto& law = warp ? fabric.measured_bending->warp : fabric.measured_bending->weft;
  return {law.initial_rigidity() / (1 - fabric.poisson * fabric.poisson), law};
}

std::vector<StretchSpring> thread_springs(const Threads& threads, const Fabric& fabric) {
  std::vector<StretchSpring> springs;
  for (const auto& s : threads.segments) {
    const double membrane = s.warp ? fabric.warp_membrane : fabric.weft_membrane;
    springs.push_back({s.i, s.j, s.length, membrane * s.width / s.length});
  }
  return springs;
}

/// Shear stiffness B' G h A of each cell, on the difference of its diagonals.
std::vector<ShearCell> shear_cells(const QuadMesh& mesh, const Fabric& fabric) {
  std::vector<ShearCell> cells;
  for (const auto& quad : mesh.quads) {
    const auto x = [&](std::size_t k) { return mesh.reference[static_cast<std::size_t>(quad[k])]; };
    const Vector3 d1 = x(2) - x(0), d2 = x(3) - x(1), p = 0.5 * (d1 - d2), q = 0.5 * (d1 + d2);
    const double area = 0.5 * d1.cross(d2).norm();
    cells.push_back({.nodes = quad,
                     .scale = p.norm() * q.norm(),
                     .rest = d1.squaredNorm() - d2.squaredNorm(),
                     .stiffness = fabric.net.shear_factor * fabric.shear_membrane * area});
  }
  return cells;
}

/// The chapter's own shear springs (43): one on each diagonal d, of stiffness B' G h A d²/(2 |p|²|q|²), which is B' G h
/// for the square cell of (43).
std::vector<StretchSpring> diagonal_springs(const QuadMesh& mesh, const Fabric& fabric) {
  std::vector<StretchSpring> springs;
  for (const auto& cell : shear_cells(mesh, fabric))
    for (const auto& [from, to] : {std::pair{cell.nodes[0], cell.nodes[2]}, std::pair{cell.nodes[1], cell.nodes[3]}}) {
      const double d =
          (mesh.reference[static_cast<std::size_t>(to)] - mesh.reference[static_cast<std::size_t>(from)]).norm();
      springs.push_back({from, to, d, cell.stiffness * d * d / (2 * cell.scale * cell.scale)});
    }
  return springs;
}

/// The springs of warp or weft, and what their laws have in common.
template <class Spring>
struct Family {
  std::vector<Spring> springs;
  std::optional<MomentCurvature> law;
};
/// Linear springs of warp and weft are one family, since their stiffness is all that tells them apart; with laws they
/// are two.
template <class Spring>
using Families = std::array<Family<Spring>, 2>;

template <class Spring>
void add(Families<Spring>& families, bool warp, const ThreadBending& bending, const Spring& spring) {
  auto& family = families[bending.law && !warp ? 1 : 0];
  family.springs.push_back(spring);
  family.law = bending.law;
}

Families<BendSpring> bend_springs(const QuadMesh& mesh, const Threads& threads, const Fabric& fabric,
                                  const std::vector<bool>& clamped) {
  Families<BendSpring> families;
  const auto x = [&](int n) { return mesh.reference[static_cast<std::size_t>(n)]; };
  for (const auto& b : threads.bends) {
    if (clamped[static_cast<std::size_t>(b.centre)]) continue;  // the clamp holds each side by itself
    const Vector3 along = x(b.centre) - x(b.previous), on = x(b.next) - x(b.centre);
    const Vector3 axis = x(b.cross_to) - x(b.cross_from) - b.skew * (along + on);
    const auto bent = bending(fabric, b.warp);
    add(families, b.warp, bent,
        BendSpring{.previous = b.previous,
                   .centre = b.centre,
                   .next = b.next,
                   .cross_from = b.cross_from,
                   .cross_to = b.cross_to,
                   .skew = std::abs(b.skew) < 1e-12 ? 0.0 : b.skew,
                   .rest_angle = HingeAngle(along, on, axis).angle,
                   .stiffness = bent.rigidity * b.width / b.length,
                   .length = b.length});
  }
  return families;
}

Families<ClampSpring> clamp_springs(const QuadMesh& mesh, const Threads& threads, const Fabric& fabric,
                                    const std::vector<Vector3>& placed, const std::vector<bool>& clamped) {
  const auto normals = node_normals(mesh, placed);
  Families<ClampSpring> families;
  for (int n = 0; n < mesh.nodes(); ++n) {
    const auto i = static_cast<std::size_t>(n);
    if (!clamped[i]) continue;
    for (const auto& end : threads.ends_at(n)) {
      const auto j = static_cast<std::size_t>(end.neighbour);
      if (clamped[j]) continue;
      const auto& segment = threads.segments[static_cast<std::size_t>(end.segment)];
      const Vector3 direction = (placed[j] - placed[i]).normalized();
      const auto bent = bending(fabric, segment.warp);
      add(families, segment.warp, bent,
          ClampSpring{.node = n,
                      .next = end.neighbour,
                      .direction = direction,
                      .axis = normals[i].cross(direction).normalized(),
                      .stiffness = 2 * bent.rigidity * segment.width / segment.length,
                      .length = 0.5 * segment.length});
    }
  }
  return families;
}

}  // namespace

std::vector<std::unique_ptr<ForceTerm>> particle_net(const QuadMesh& mesh, const Threads& threads, const Fabric& fabric,
                                                     const std::vector<Vector3>& placed,
                                                     const std::vector<bool>& clamped) {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  const auto& damping = fabric.damping;
  terms.push_back(std::make_unique<StretchSprings>(thread_springs(threads, fabric), EnergyKind::membrane,
                                                   damping.membrane, fabric.net.compression_factor));
  if (fabric.net.diagonal_springs)
    terms.push_back(std::make_unique<StretchSprings>(diagonal_springs(mesh, fabric), EnergyKind::shear,
                                                     damping.membrane, fabric.net.diagonal_compression_factor));
  else
    terms.push_back(std::make_unique<CellShear>(shear_cells(mesh, fabric), damping.membrane));
  for (const auto& [springs, law] : bend_springs(mesh, threads, fabric, clamped))
    if (!springs.empty()) terms.push_back(std::make_unique<BendSprings>(springs, damping.bending, law));
  for (const auto& [springs, law] : clamp_springs(mesh, threads, fabric, placed, clamped))
    if (!springs.empty()) terms.push_back(std::make_unique<ClampSprings>(springs, damping.bending, law));
  return terms;
}

Vector lumped_mass(const QuadMesh& mesh, const Fabric& fabric) {
  const auto areas = tributary_areas(mesh);
  return fabric.area_density * Eigen::Map<const Vector>(areas.data(), static_cast<Eigen::Index>(areas.size()));
}

std::vector<LoadedEdge> moment_on_edge(const QuadMesh& mesh, const Threads& threads, const std::vector<int>& nodes,
                                       const Vector3& total) {
  const auto lengths = tributary_edge_lengths(mesh, nodes);
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (!(whole > 0)) throw std::invalid_argument("a moment needs nodes along an edge of the sheet");
  std::vector<LoadedEdge> edges;
  for (const int n : nodes) {
    const auto ends = threads.ends_at(n);
    const auto inward = std::ranges::find_if(ends, [&](const ThreadEnd& end) {
      return end.through < 0 && std::ranges::find(nodes, end.neighbour) == nodes.end();
    });
    if (inward == ends.end()) throw std::invalid_argument("a moment needs nodes where a thread ends");
    edges.push_back({inward->neighbour, n, total * (lengths[static_cast<std::size_t>(n)] / whole)});
  }
  return edges;
}

}  // namespace sundrape

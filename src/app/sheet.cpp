#include "sheet.hpp"

#include <cmath>
#include <numeric>

#include "sundrape/app/model.hpp"
#include "sundrape/force/director_length.hpp"
#include "sundrape/force/director_moment.hpp"
#include "sundrape/force/edge_moment.hpp"
#include "sundrape/force/particle_net.hpp"
#include "sundrape/force/shell.hpp"
#include "sundrape/mesh/directors.hpp"

namespace sundrape {
namespace {

MembraneField membrane_field(ShellMembrane membrane) {
  switch (membrane) {
    case ShellMembrane::bilinear:
      return MembraneField::bilinear;
    case ShellMembrane::edge_tied:
      return MembraneField::edge_tied;
    case ShellMembrane::mixed:
      return MembraneField::mixed;
    case ShellMembrane::centre:
      break;
  }
  return MembraneField::centre;
}

ShellSection section_of(const Case& c) {
  const auto& damping = c.fabric.damping;
  return {.membrane = membrane_stiffness(c.fabric),
          .shear = c.shell.shear_correction * c.fabric.transverse_shear,
          .bending = plate_bending(c.fabric),
          .membrane_damping = damping.membrane,
          .bending_damping = damping.bending};
}

/// Mass of a director's point over that of its node: of ρ h³/12 the part that the case asks for. In statics, where
/// motion is a way to find an equilibrium, directors get a tenth of a node's mass, so that none of them can turn
/// singular.
double director_inertia(const Case& c, double director_length) {
  if (c.analysis != Analysis::dynamics) return 0.1;
  if (c.shell.director == ShellDirector::massless) return 0;
  return c.shell.rotary_inertia * std::pow(c.fabric.thickness / director_length, 2) / 12;
}

/// Positions and directors of a node next to each other.
std::vector<int> interleaved(int nodes) {
  std::vector<int> order;
  order.reserve(2 * static_cast<std::size_t>(nodes));
  for (int i = 0; i < nodes; ++i) order.insert(order.end(), {i, nodes + i});
  return order;
}

}  // namespace

Sheet net_sheet(const Case& c, const QuadMesh& mesh, const Threads& threads, const std::vector<Vector3>& placed,
                const Supports& supports) {
  Sheet sheet;
  sheet.mass = lumped_mass(mesh, c.fabric);
  sheet.terms = particle_net(mesh, threads, c.fabric, placed, supports.clamped);
  sheet.order.resize(placed.size());
  std::iota(sheet.order.begin(), sheet.order.end(), 0);
  return sheet;
}

Sheet shell_sheet(const Case& c, const QuadMesh& mesh) {
  const auto& fabric = c.fabric;
  const int n = mesh.nodes();
  Sheet sheet;
  // As long as half a cell a director's point has about the stiffness of a node's, and its errors weigh like a node's.
  sheet.director_length = 0.5 * mean_edge_length(mesh);
  const auto directors = rest_directors(mesh);
  const Vector node_mass = lumped_mass(mesh, fabric);
  sheet.mass.resize(2 * n);
  sheet.mass << node_mass, director_inertia(c, sheet.director_length) * node_mass;
  sheet.order = interleaved(n);

  const auto section = section_of(c);
  const auto measure = c.shell.bending == ShellBending::geodesic ? CurvatureMeasure::geodesic : CurvatureMeasure::chord;
  const ShellOptions options{membrane_field(c.shell.membrane), measure, sheet.director_length};
  const auto elements = shell_elements(mesh, directors, c.shell.hourglass_factor);
  sheet.terms.push_back(std::make_unique<Shell>(elements, section, options));
  sheet.gauges.emplace(elements, section, options);
  const double modulus = std::sqrt(fabric.warp_membrane * fabric.weft_membrane);
  const auto areas = tributary_areas(mesh);
  std::vector<DirectorSpring> springs;
  springs.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) springs.push_back({n + i, modulus * areas[static_cast<std::size_t>(i)]});
  sheet.terms.push_back(
      std::make_unique<DirectorLength>(std::move(springs), sheet.director_length, fabric.damping.membrane));

  const Matrix3 turn = placement(c.cloth.place).rotation;
  for (const auto& t : directors) sheet.directors.emplace_back(turn * t);
  return sheet;
}

std::unique_ptr<ForceTerm> moment_load(const Sheet& sheet, const QuadMesh& mesh, const Threads& threads,
                                       const std::vector<int>& nodes, const Vector3& total, LoadCourse course) {
  if (sheet.director_length == 0)
    return std::make_unique<EdgeMoment>(moment_on_edge(mesh, threads, nodes, total), std::move(course));
  const auto lengths = tributary_edge_lengths(mesh, nodes);
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  std::vector<LoadedDirector> loaded;
  for (const int i : nodes) {
    const double share =
        whole > 0 ? lengths[static_cast<std::size_t>(i)] / whole : 1 / static_cast<double>(nodes.size());
    if (share > 0) loaded.push_back({mesh.nodes() + i, share * total});
  }
  return std::make_unique<DirectorMoment>(std::move(loaded), std::move(course));
}

}  // namespace sundrape

#include "sheet.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "sundrape/app/model.hpp"
#include "sundrape/force/director_length.hpp"
#include "sundrape/force/director_moment.hpp"
#include "sundrape/force/edge_moment.hpp"
#include "sundrape/force/particle_net.hpp"
#include "sundrape/force/shell.hpp"
#include "sundrape/io/case_error.hpp"
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

ShellSection section_of(const Case& c, const Fabric& fabric) {
  const auto& damping = fabric.damping;
  return {.membrane = membrane_stiffness(fabric),
          .shear = c.shell.shear_correction * fabric.transverse_shear,
          .bending = plate_bending(fabric),
          .membrane_damping = damping.membrane,
          .bending_damping = damping.bending};
}

/// Mass of a director's point over that of its node: of ρ h³/12 the part that the case asks for. In statics, where
/// motion is a way to find an equilibrium, directors get a tenth of a node's mass, so that none of them can turn
/// singular.
double director_inertia(const Case& c, const Fabric& fabric, double director_length) {
  if (c.analysis != Analysis::dynamics) return 0.1;
  if (c.shell.director == ShellDirector::massless) return 0;
  return c.shell.rotary_inertia * std::pow(fabric.thickness / director_length, 2) / 12;
}

/// Positions and directors of a node next to each other.
std::vector<int> interleaved(int nodes) {
  std::vector<int> order;
  order.reserve(2 * static_cast<std::size_t>(nodes));
  for (int i = 0; i < nodes; ++i) order.insert(order.end(), {i, nodes + i});
  return order;
}

}  // namespace

Sheet net_sheet(const Case& c, const Cloth& cloth, const Threads& threads, const Supports& supports) {
  Sheet sheet;
  sheet.mass = Vector::Zero(cloth.mesh.nodes());
  for (std::size_t k = 0; k < cloth.pieces.size(); ++k) {
    const auto& piece = cloth.pieces[k];
    const auto& fabric = c.pieces[k].fabric;
    const auto mesh = only(cloth.mesh, piece);
    sheet.mass += lumped_mass(mesh, fabric);
    const auto own_threads = threads_between(threads, piece.first_node, piece.first_node + piece.nodes);
    auto terms = particle_net(mesh, own_threads, fabric, cloth.placed, supports.clamped);
    std::ranges::move(terms, std::back_inserter(sheet.terms));
  }
  sheet.order.resize(cloth.placed.size());
  std::iota(sheet.order.begin(), sheet.order.end(), 0);
  return sheet;
}

Sheet shell_sheet(const Case& c, const Cloth& cloth) {
  const int n = cloth.mesh.nodes();
  Sheet sheet;
  // As long as half a cell a director's point has about the stiffness of a node's, and its errors weigh like a node's.
  sheet.director_length = 0.5 * mean_edge_length(cloth.mesh);
  const auto directors = rest_directors(cloth.mesh);
  sheet.mass = Vector::Zero(2 * n);
  sheet.order = interleaved(n);
  const auto measure = c.shell.bending == ShellBending::geodesic ? CurvatureMeasure::geodesic : CurvatureMeasure::chord;
  const ShellOptions options{membrane_field(c.shell.membrane), measure, sheet.director_length};
  const auto areas = tributary_areas(cloth.mesh);
  for (std::size_t k = 0; k < cloth.pieces.size(); ++k) {
    const auto& piece = cloth.pieces[k];
    const auto& of_case = c.pieces[k];
    const auto& fabric = of_case.fabric;
    const auto mesh = only(cloth.mesh, piece);
    const Vector node_mass = lumped_mass(mesh, fabric);
    sheet.mass.head(n) += node_mass;
    sheet.mass.tail(n) += director_inertia(c, fabric, sheet.director_length) * node_mass;

    const auto section = section_of(c, fabric);
    const auto elements = [&] {
      try {
        return shell_elements(mesh, directors, c.shell.hourglass_factor);
      } catch (const std::invalid_argument& problem) {
        const auto* file = std::get_if<MeshShape>(&of_case.cloth.shape);
        throw CaseError(file ? file->source : SourceLine{}, problem.what());
      }
    }();
    sheet.terms.push_back(std::make_unique<Shell>(elements, section, options));
    sheet.gauges.emplace_back(elements, section, options);
    const double modulus = std::sqrt(fabric.warp_membrane * fabric.weft_membrane);
    std::vector<DirectorSpring> springs;
    springs.reserve(static_cast<std::size_t>(piece.nodes));
    for (int i = piece.first_node; i < piece.first_node + piece.nodes; ++i)
      springs.push_back({n + i, modulus * areas[static_cast<std::size_t>(i)]});
    sheet.terms.push_back(
        std::make_unique<DirectorLength>(std::move(springs), sheet.director_length, fabric.damping.membrane));
  }
  for (const auto& t : directors) sheet.directors.emplace_back(cloth.placement.rotation * t);
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

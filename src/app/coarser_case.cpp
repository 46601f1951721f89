#include "sundrape/app/coarser_case.hpp"

#include <algorithm>
#include <cmath>

#include "sundrape/io/case_error.hpp"

namespace sundrape {
namespace {

constexpr int least_nodes = 300;                                     // of a mesh that is worth starting elsewhere
constexpr int enough_nodes = 1000;                                   // of a mesh that is coarse enough to start from
constexpr int least_cells = 8;                                       // each way, where they are halved
constexpr double longest_net_edge = 1.1, longest_shell_edge = 0.35;  // in bending lengths

/// Half as many cells, or as many more as `extra` says where they are even then: some supports want a node in the
/// middle.
int halved(int cells, int extra, int least) {
  const int half = (cells + 1) / 2 + extra;
  return half < least ? cells : half;
}

std::optional<ClothCase> with_fewer_cells(ClothCase cloth, int extra) {
  if (auto* s = std::get_if<RectangleShape>(&cloth.shape)) {
    const int before = s->cells_warp * s->cells_weft;
    s->cells_warp = halved(s->cells_warp, extra, least_cells);
    s->cells_weft = halved(s->cells_weft, extra, least_cells);
    if (s->cells_warp * s->cells_weft >= before) return {};
  } else if (auto* d = std::get_if<DiscShape>(&cloth.shape)) {
    const int before = d->cells;
    d->cells = halved(d->cells, extra, least_cells);
    if (d->cells >= before) return {};
  } else if (auto* a = std::get_if<AnnulusShape>(&cloth.shape)) {
    const int before = a->cells_around * a->cells_radial;
    a->cells_radial = halved(a->cells_radial, extra, least_cells / 2);
    a->cells_around = halved(a->cells_around, extra, 2 * least_cells);
    if (a->cells_around * a->cells_radial >= before) return {};
  } else {
    return {};
  }
  return cloth;
}

/// What selectors of supports and loads pick, in the order of the case.
std::vector<std::pair<const Selector*, std::vector<int>>> picked(const Case& c, const QuadMesh& mesh) {
  std::vector<std::pair<const Selector*, std::vector<int>>> all;
  const auto placed = place(mesh.reference, c.sheet().cloth.place);
  const auto add = [&](const Selector& selector) { all.emplace_back(&selector, select(selector, mesh, placed)); };
  for (const auto& fix : c.fixes) add(fix.nodes);
  for (const auto& load : c.loads)
    std::visit(
        [&](const auto& l) {
          if constexpr (requires { l.nodes; }) add(l.nodes);
        },
        load.load);
  return all;
}

/// Whether a set is the same part of the sheet on every mesh of its shape.
bool is_part_of_shape(const Selector& selector) {
  const auto* set = std::get_if<NamedSet>(&selector);
  return set != nullptr && set->name != "centre";
}

bool picks_the_same(const Case& c, const QuadMesh& fine, const QuadMesh& coarse) {
  const auto on_fine = picked(c, fine), on_coarse = picked(c, coarse);
  const double same = 1e-6 * diagonal(fine), near = 1.5 * mean_edge_length(coarse);
  /// Whether each of `nodes` stands within `reach` of one of `others`.
  const auto all_close = [](const QuadMesh& mesh, const std::vector<int>& nodes, const QuadMesh& other,
                            const std::vector<int>& others, double reach) {
    return std::ranges::all_of(nodes, [&](int i) {
      return std::ranges::any_of(others, [&](int j) {
        return (mesh.reference[static_cast<std::size_t>(i)] - other.reference[static_cast<std::size_t>(j)]).norm() <=
               reach;
      });
    });
  };
  for (std::size_t k = 0; k < on_fine.size(); ++k) {
    const auto& [selector, nodes] = on_fine[k];
    const auto& coarse_nodes = on_coarse[k].second;
    if (is_part_of_shape(*selector)) continue;
    if (!all_close(coarse, coarse_nodes, fine, nodes, same) || !all_close(fine, nodes, coarse, coarse_nodes, near))
      return false;
  }
  return true;
}

double longest_edge(const Case& c, const CaseModel& model) {
  const double bending = std::max(c.sheet().fabric.warp_bending, c.sheet().fabric.weft_bending);
  const double bending_length = std::cbrt(bending / model.area_weight);
  return bending_length * (c.model == Model::shell ? longest_shell_edge : longest_net_edge);
}

std::optional<CoarserCase> coarser(const Case& c, const CaseModel& model) {
  for (const int extra : {0, 1}) {
    auto cloth = with_fewer_cells(c.sheet().cloth, extra);
    if (!cloth) continue;
    Case coarse = c;
    coarse.sheet().cloth = std::move(*cloth);
    coarse.output.probes.clear();
    try {
      auto built = build_model(coarse);
      if (mean_edge_length(built.mesh) <= longest_edge(c, model) && picks_the_same(c, model.mesh, built.mesh))
        return CoarserCase{std::move(coarse), std::move(built)};
    } catch (const CaseError&) {  // a selector picks nothing there, or supports cannot be had
    }
  }
  return {};
}

}  // namespace

std::vector<CoarserCase> coarser_cases(const Case& c, const CaseModel& model) {
  std::vector<CoarserCase> cases;
  if (model.mesh.nodes() < least_nodes || c.pieces.size() > 1) return cases;
  auto next = coarser(c, model);
  while (next) {
    cases.push_back(std::move(*next));
    const auto& last = cases.back();
    next = last.model.mesh.nodes() > enough_nodes ? coarser(last.c, last.model) : std::nullopt;
  }
  return cases;
}

}  // namespace sundrape

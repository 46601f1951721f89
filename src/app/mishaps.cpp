#include "sundrape/app/mishaps.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sundrape {
namespace {

std::string place_of(ConstVectorRef x) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", x[0], x[1], x[2]); }

}  // namespace

Mishaps::Mishaps(const Case& c, const CaseModel& model) : case_(c), model_(model) {
  if (!c.moves() || model.contact == nullptr) return;
  const State start{0, model.initial, model.initial};
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    const auto& piece = model.pieces[k];
    for (int n = piece.first_node; n < piece.first_node + piece.nodes; ++n) {
      const double gap = model.contact->closest(start, point(start.q, n)).gap;
      lowest_gaps_.push_back(std::min(gap, 0.0) - c.pieces[k].fabric.thickness);
    }
  }
}

std::optional<std::string> Mishaps::at(const State& all) const {
  if (auto torn = tear(all)) return torn;
  return collision(all);
}

std::optional<std::string> Mishaps::tear(const State& all) const {
  if (!case_.breaking_strain) return std::nullopt;
  const auto most = model_.edge_strains.most_stretched(all.q);
  if (most.strain <= *case_.breaking_strain) return std::nullopt;
  return fmt::format(
      "the cloth tears: the edge from node {} at {} to node {} is stretched by {:.3g} %, more than "
      "material.breaking_strain = {:.3g} %; look whether the paths of supports and obstacles pull it apart",
      most.i, place_of(point(all.q, most.i)), most.j, 100 * most.strain, 100 * *case_.breaking_strain);
}

std::optional<std::string> Mishaps::collision(const State& all) const {
  for (std::size_t n = 0; n < lowest_gaps_.size(); ++n) {
    const int node = static_cast<int>(n);
    if (!model_.system->unknowns().is_held(node)) continue;
    const auto surface = model_.contact->closest(all, point(all.q, node));
    if (surface.gap > lowest_gaps_[n]) continue;
    return fmt::format(
        "obstacle '{}' and held cloth run into each other: node {} at {} is {:.3g} mm inside; change the path of "
        "one of them, or release the cloth before",
        model_.obstacles[surface.body].name, node, place_of(point(all.q, node)), -1e3 * surface.gap);
  }
  return std::nullopt;
}

}  // namespace sundrape

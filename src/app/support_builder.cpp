#include "support_builder.hpp"

#include <algorithm>

#include "sundrape/app/obstacles.hpp"
#include "sundrape/io/case_error.hpp"

#include "pick.hpp"

namespace sundrape {

SupportBuilder::SupportBuilder(const Case& c, CaseModel& model, const std::vector<Vector3>& placed)
    : case_(c), model_(model), placed_(placed), start_(placed.size()), lasting_(placed.size()) {
  for (const auto& fix : c.fixes)
    add({fix.name, fix.nodes, fix.grip, fix.source}, {fix.components, fix.rotation, fix.director}, std::nullopt);
  for (const auto& motion : c.motions)
    add({motion.name, motion.nodes, motion.grip, motion.source},
        {motion.components, motion.rotation, {motion.rotation, motion.rotation, motion.rotation}},
        PrescribedMotion{{}, motion.components, course_of(motion.course)});
  for (const auto& [source, nodes] : taken_)
    if (std::ranges::any_of(nodes, [&](int n) { return held_for_good(n); }))
      throw CaseError(source, "selects nodes that another support holds for good: nothing can carry them away");
  model.clamped_for_good = lasting_.clamped;
}

void SupportBuilder::add(const Which& which, const What& what, std::optional<PrescribedMotion> motion) {
  const auto& [name, selector, grip, source] = which;
  const bool at_start = !grip.from.has_value(), lasts = at_start && !grip.until;
  // whoever takes hold later finds its nodes then, but a set that the mesh does not have is an error now
  const bool known = at_start || std::holds_alternative<NamedSet>(selector);
  const auto nodes = known ? pick(selector, model_.mesh, placed_, source) : std::vector<int>{};
  if (at_start) hold(start_, nodes, what);
  if (lasts) hold(lasting_, nodes, what);
  CaseModel::ReactionSet reaction{name, lasts ? nodes : std::vector<int>{}};
  if (!lasts) {
    reaction.motion = motions_.size();
    model_.grippers.push_back({name, selector, grip, source, motion.has_value(), what.clamps, motions_.size(),
                               at_start ? nodes : std::vector<int>{}});
    if (motion) taken_.emplace_back(source, nodes);
    if (!motion) motion = PrescribedMotion{{}, what.position, {LinePath{Vector3::Zero()}}};
  } else if (motion) {
    motion->points = nodes;
    if (what.clamps && case_.model == Model::shell)
      for (const int n : nodes) motion->directions.push_back(model_.mesh.nodes() + n);
  }
  if (motion) motions_.push_back(std::move(*motion));
  model_.reactions.push_back(std::move(reaction));
}

void SupportBuilder::hold(Supports& supports, const std::vector<int>& nodes, const What& what) {
  for (const int node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    for (std::size_t k = 0; k < 3; ++k) {
      supports.position[i][k] |= what.position[k];
      supports.director[i][k] |= what.director[k];
    }
    if (what.clamps) supports.clamped[i] = true;
  }
}

}  // namespace sundrape

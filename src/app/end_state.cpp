#include "sundrape/app/end_state.hpp"

#include <array>

#include <nlohmann/json.hpp>

#include "sundrape/app/last_shape.hpp"
#include "sundrape/app/solver_choice.hpp"
#include "sundrape/statics/relaxation.hpp"
#include "sundrape/statics/stability.hpp"

namespace sundrape {
namespace {

nlohmann::json as_json(const std::map<std::string, Vector3>& vectors) {
  auto json = nlohmann::json::object();
  for (const auto& [name, v] : vectors) json[name] = std::array{v.x(), v.y(), v.z()};
  return json;
}

}  // namespace

CaseModel weighing_model(Case c) {
  c.cloth.waviness_at_rest = is_wavy_at_rest(c);  // by default a matter of the analysis
  c.analysis = Analysis::relaxation;
  return build_model(c);
}

CaseModel perfect_model(Case c) {
  c.cloth.waviness_amplitude = 0;
  c.cloth.waviness_given = true;
  return weighing_model(std::move(c));
}

EndState weigh(const CaseModel& model, Vector q) {
  EndState state;
  state.q = std::move(q);
  const Vector still = Vector::Zero(state.q.size());
  const State all{0, state.q, still};
  const auto e = model.system->energies(all);
  state.energy = {{"membrane", e.membrane}, {"shear", e.shear},     {"bending", e.bending},
                  {"gravity", e.gravity},   {"contact", e.contact}, {"load", e.load}};
  state.total_energy = e.stored();
  state.residual = relative_residual(*model.system, all, model.nominal_weight());
  state.negative_pivots = negative_pivots(*model.system, all, neutral_frequency(model));
  for (const auto& probe : model.probes) state.probes[probe.name] = point(state.q, probe.node);
  state.held_forces = Vector::Zero(state.q.size());
  Vector forces = state.held_forces;
  model.system->force(all, forces);
  for (Eigen::Index k = 0; k < forces.size(); ++k)
    if (model.system->unknowns().is_held(static_cast<int>(k / 3), static_cast<int>(k % 3)))
      state.held_forces[k] = forces[k];
  for (const auto& set : model.reactions) state.reactions[set.name] = reaction(model, all, set.nodes).force;
  return state;
}

EndState end_state(const CaseModel& model, const ResultReader& result) {
  return weigh(model, last_state(result, model));
}

nlohmann::json to_json(const EndState& state) {
  return {{"energy_J", state.energy},          {"total_energy_J", state.total_energy},
          {"residual", state.residual},        {"negative_pivots", state.negative_pivots.value_or(-1)},
          {"probes_m", as_json(state.probes)}, {"reactions_N", as_json(state.reactions)}};
}

}  // namespace sundrape

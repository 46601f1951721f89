#include "sundrape/app/end_state.hpp"

#include <array>

#include <nlohmann/json.hpp>

#include "sundrape/app/last_shape.hpp"
#include "sundrape/app/solver_choice.hpp"
#include "sundrape/app/support_schedule.hpp"
#include "sundrape/statics/relaxation.hpp"
#include "sundrape/statics/stability.hpp"
#include "sundrape/system/equivariance.hpp"

namespace sundrape {
namespace {

nlohmann::json as_json(const std::map<std::string, Vector3>& vectors) {
  auto json = nlohmann::json::object();
  for (const auto& [name, v] : vectors) json[name] = std::array{v.x(), v.y(), v.z()};
  return json;
}

Vector held_forces(const CaseModel& model, const State& all) {
  Vector forces(all.q.size());
  model.system->force(all, forces);
  const auto& unknowns = model.system->unknowns();
  for (int p = 0; p < unknowns.points(); ++p)
    for (int k = 0; k < 3; ++k)
      if (!unknowns.is_held(p, k)) forces[3 * p + k] = 0;
  return forces;
}

}  // namespace

CaseModel weighing_model(Case c) {
  for (auto& piece : c.pieces)
    piece.cloth.waviness_at_rest = is_wavy_at_rest(c, piece);  // by default a matter of the analysis
  c.analysis = Analysis::relaxation;
  return build_model(c);
}

CaseModel perfect_model(Case c) {
  for (auto& piece : c.pieces) {
    piece.cloth.waviness_amplitude = 0;
    piece.cloth.waviness_given = true;
  }
  return weighing_model(std::move(c));
}

EndState end_state(const CaseModel& model, const ResultReader& result) {
  const Vector q = last_state(result, model), still = Vector::Zero(q.size());
  const double time = result.frame_variable() == FrameVariable::time ? result.frame_values().back() : after_everything;
  const State all{time, q, still, statics_by_time};
  if (const auto checkpoint = result.checkpoint(); checkpoint && checkpoint->arrays.contains("schedule"))
    SupportSchedule(model).resume(checkpoint->arrays.at("schedule"), all);
  EndState state;
  const auto e = model.system->energies(all);
  state.energy = {{"membrane", e.membrane}, {"shear", e.shear},     {"bending", e.bending},
                  {"gravity", e.gravity},   {"contact", e.contact}, {"load", e.load}};
  state.total_energy = e.stored();
  state.residual = relative_residual(*model.system, all, model.nominal_weight());
  state.negative_pivots = negative_pivots(*model.system, all, neutral_frequency(model));
  return moved(std::move(state), model, q, held_forces(model, all));
}

EndState moved(EndState state, const CaseModel& model, Vector q, Vector held_forces) {
  state.q = std::move(q);
  state.held_forces = std::move(held_forces);
  for (const auto& probe : model.probes) state.probes[probe.name] = point(state.q, probe.node);
  for (const auto& set : model.reactions) {
    auto& reaction = state.reactions[set.name] = Vector3::Zero();
    for (const int n : model.nodes_of(set)) reaction += point(state.held_forces, n);
  }
  return state;
}

nlohmann::json to_json(const EndState& state) {
  return {{"energy_J", state.energy},          {"total_energy_J", state.total_energy},
          {"residual", state.residual},        {"negative_pivots", state.negative_pivots.value_or(-1)},
          {"probes_m", as_json(state.probes)}, {"reactions_N", as_json(state.reactions)}};
}

}  // namespace sundrape

#pragma once
#include <map>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "sundrape/app/model.hpp"
#include "sundrape/io/result_reader.hpp"

namespace sundrape {

/// Where a run ended, weighed by its own model: the same measures whichever analysis got there, at rest and with loads
/// in full.
struct EndState {
  Vector q;                                  // 3P [m]
  std::map<std::string, double> energy;      // by kind, with `load` the potential of loads [J]
  double total_energy = 0;                   // their sum [J]
  double residual = 0;                       // |out-of-balance force| / |external force|
  std::optional<int> negative_pivots;        // of the tangent; nothing if its factorisation broke down
  std::map<std::string, Vector3> probes;     // places of the probed nodes [m]
  std::map<std::string, Vector3> reactions;  // by support [N]
  Vector held_forces;                        // on held components, which supports balance; 3P [N]
};

/// The model that a case's end is weighed by: loads in full, whatever their ramp, and its own rest shape.
[[nodiscard]] CaseModel weighing_model(Case c);

/// The same without any waviness: the one that has the symmetries.
[[nodiscard]] CaseModel perfect_model(Case c);

/// The last frame of a result, weighed with supports and obstacles where they are then; grippers of the model are left
/// as they were in the result's end.
/// @param model  as weighing_model or perfect_model makes it
/// @throws FileError  as last_state
[[nodiscard]] EndState end_state(const CaseModel& model, const ResultReader& result);

/// An end moved as a whole to where a symmetry or a neutral motion of the case takes it: energies stay, forces turn.
/// @param q            where its points are then, 3P [m]
/// @param held_forces  as they act there, 3P [N]
[[nodiscard]] EndState moved(EndState state, const CaseModel& model, Vector q, Vector held_forces);

[[nodiscard]] nlohmann::json to_json(const EndState& state);

}  // namespace sundrape

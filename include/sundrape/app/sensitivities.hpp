#pragma once
#include <memory>
#include <vector>

#include "sundrape/app/model.hpp"
#include "sundrape/integrate/forward_sensitivity.hpp"
#include "sundrape/statics/static_sensitivity.hpp"

namespace sundrape {

/// What a case asks to be differentiated by: for each parameter the model of the case with the parameter a little
/// larger, and how its forces differ from those of the case's own model.
class Sensitivities {
 public:
  /// @throws CaseError  a parameter at the edge of its range, or one that changes which points or forces there are
  Sensitivities(const Case& c, const CaseModel& model);

  /// |p| d(initial state)/dp, one a parameter, 3P [m].
  [[nodiscard]] std::vector<Vector> of_start() const;
  [[nodiscard]] std::vector<ParameterDerivative*> derivatives();
  /// The system with its whole tangent, of which Newton's iteration has friction's secant only. The integrator and the
  /// solver of equilibria do not use it: where cloth touches cloth its matrices change their structure as they please.
  [[nodiscard]] const System& exact_system() const { return *exact_.system; }
  /// All other models, whose supports have to change as those of the case's own.
  [[nodiscard]] std::vector<const CaseModel*> models() const;

  /// Derivatives of an equilibrium per SI unit, one a parameter; empty where the tangent is singular.
  [[nodiscard]] std::vector<FrameSensitivity> at_equilibrium(const State& all);
  /// Derivatives of a motion per SI unit, at a time within the last step, one a parameter.
  [[nodiscard]] std::vector<FrameSensitivity> of_motion(const ForwardSensitivity& motion, double time);

 private:
  struct Parameter {
    double size = 0;  // |p|, SI
    CaseModel changed;
    std::unique_ptr<ParameterDerivative> derivative;
  };
  const CaseModel& model_;
  std::vector<Parameter> parameters_;
  CaseModel exact_;
  StaticSensitivity statics_;
};

}  // namespace sundrape

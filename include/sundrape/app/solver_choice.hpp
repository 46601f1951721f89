#pragma once
#include <memory>

#include "sundrape/app/model.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/statics/equilibrium_path.hpp"
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

/// Tolerances and steps of a dynamic case.
[[nodiscard]] IntegratorOptions integrator_options(const Case& c, const CaseModel& model);

/// Frequency below which motion counts as free [1/s]: 10⁻³ √(g/L).
[[nodiscard]] double neutral_frequency(const CaseModel& model);
/// How far an unstable equilibrium is pushed along its mode, to see where it falls [m]: a thousandth of the sheet's
/// size.
[[nodiscard]] double push_of_unstable(const CaseModel& model);

/// Control, step lengths and scales of an arc-length case.
[[nodiscard]] PathOptions path_options(const Case& c, const CaseModel& model);

/// The linear solver that implicit integration of a case takes; "auto": conjugate gradients, which win at every size
/// while mass matters, but LU for moments without an energy.
[[nodiscard]] std::unique_ptr<LinearSolver> dynamics_solver(const Case& c);

/// The one that sensitivities of a motion take: exact where that is only nearly so.
[[nodiscard]] std::unique_ptr<LinearSolver> sensitivity_solver(const Case& c);

/// Tolerance, steps and limits of a relaxation. The energy may rise by a twentieth of weight times size in a step: less
/// costs steps, since a long one along a fold stretches the cloth and the next one gives that back.
[[nodiscard]] RelaxationOptions relaxation_options(const Case& c, const CaseModel& model);

/// The linear solver that a relaxation takes; "auto": where ∂f/∂q is symmetric conjugate gradients while they take less
/// than a hundred iterations, from there on Cholesky; else LU.
[[nodiscard]] std::unique_ptr<LinearSolver> statics_solver(const Case& c, const System& system);

}  // namespace sundrape

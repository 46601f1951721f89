#pragma once
#include <memory>

#include "sundrape/app/model.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/statics/equilibrium_path.hpp"

namespace sundrape {

/// Tolerances and steps of a dynamic case.
[[nodiscard]] IntegratorOptions integrator_options(const Case& c, const CaseModel& model);

/// Control, step lengths and scales of an arc-length case.
[[nodiscard]] PathOptions path_options(const Case& c, const CaseModel& model);

/// The linear solver that implicit integration of a case takes; "auto": conjugate gradients, which win at every size
/// while mass matters, but LU for moments without an energy.
[[nodiscard]] std::unique_ptr<LinearSolver> dynamics_solver(const Case& c);

/// The linear solver that a relaxation takes; "auto": Cholesky where ∂f/∂q is symmetric, else LU.
[[nodiscard]] std::unique_ptr<LinearSolver> statics_solver(const Case& c, const System& system);

}  // namespace sundrape

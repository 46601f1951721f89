#include "sundrape/app/solver_choice.hpp"

#include <algorithm>
#include <cmath>

#include "sundrape/integrate/default_tolerances.hpp"
#include "sundrape/linalg/block_incomplete_cholesky.hpp"
#include "sundrape/linalg/conjugate_gradients.hpp"
#include "sundrape/linalg/refined_solver.hpp"
#include "sundrape/linalg/turning_solver.hpp"

namespace sundrape {
namespace {

/// The modified factorisation suits a net's springs; with a shell it breaks down at nearly every matrix and needs
/// shifts that take nine tenths of its use away.
std::unique_ptr<LinearSolver> conjugate_gradients(Model model, int max_iterations = 500) {
  auto preconditioner = model == Model::shell ? std::make_unique<BlockIncompleteCholesky>(0.0)
                                              : std::make_unique<BlockIncompleteCholesky>();
  return std::make_unique<ConjugateGradients>(std::move(preconditioner), max_iterations);
}

// What is held must creep by its law, not by what Newton's iteration leaves (docs/friction.md).
constexpr double accuracy_of_friction = 0.1, accuracy_of_friction_in_ida = 0.03;

constexpr int iterations_worth_a_factorisation = 100;

std::unique_ptr<LinearSolver> named(const std::string& name, Model model) {
  if (name == "cholesky") return make_linear_solver(SolverKind::cholesky);
  if (name == "lu") return make_linear_solver(SolverKind::lu);
  return conjugate_gradients(model);
}

/// A factor of a narrow strip has hardly more entries than its matrix. Iterations are inexact in just the slow motions
/// across it that matter, for a residual does not see them next to the membrane (docs/folding.md).
bool is_narrow(const ClothCase& cloth) {
  constexpr int few = 4;  // cells
  const auto* strip = std::get_if<RectangleShape>(&cloth.shape);
  return strip != nullptr && std::min(strip->cells_warp, strip->cells_weft) <= few;
}

}  // namespace

IntegratorOptions integrator_options(const Case& c, const CaseModel& model) {
  const auto& d = c.dynamics;
  IntegratorOptions o;
  o.rtol = d.rtol;
  const auto defaults = default_tolerances(d.rtol, model.size, model.gravity);
  o.atol_position = d.atol_position.value_or(defaults.position);
  o.atol_velocity = d.atol_velocity.value_or(defaults.velocity);
  o.rate_slack = model.rate_slack;
  o.max_order = d.max_order;
  o.first_step = d.first_step;
  o.max_step = d.max_step;
  o.fixed_step = d.step.value_or(0);
  o.solves_always = !c.sensitivities.empty();
  if (model.has_friction())
    o.newton_accuracy = d.integrator == IntegratorKind::ida ? accuracy_of_friction_in_ida : accuracy_of_friction;
  return o;
}

double neutral_frequency(const CaseModel& model) { return 1e-3 * std::sqrt(model.gravity / model.size); }

double push_of_unstable(const CaseModel& model) { return 1e-3 * model.size; }

PathOptions path_options(const Case& c, const CaseModel& model) {
  const auto& a = c.arc_length;
  PathOptions o;
  o.control = a.control == PathControlKind::load ? PathControl::load : PathControl::arc_length;
  o.stages = c.stages();
  o.tolerance = a.tolerance;
  o.target_iterations = a.target_iterations;
  o.accelerate = a.acceleration;
  o.first_increment = a.first_increment;
  o.max_iterations = a.max_iterations;
  o.max_steps = a.max_steps;
  o.size = model.size;
  o.largest_move = a.largest_move.value_or(model.size / 10);
  o.neutral_frequency = neutral_frequency(model);
  o.force_scale = model.force_scale();
  o.fall = a.fall;
  o.push = push_of_unstable(model);
  o.relaxation = relaxation_options(c, model);
  o.relaxation.tolerance = a.tolerance;
  o.branch = a.branch;
  o.branch_amplitude = a.branch_amplitude.value_or(0.01 * model.size);
  if (a.at_bifurcation == BifurcationKind::switch_branch) o.at_bifurcation = AtBifurcation::switch_branch;
  if (a.at_bifurcation == BifurcationKind::stop) o.at_bifurcation = AtBifurcation::stop;
  return o;
}

std::unique_ptr<LinearSolver> dynamics_solver(const Case& c) {
  const auto& name = c.dynamics.linear_solver;
  // the symmetric part is good enough for the little that a pressure turns
  bool skew = false, narrow = true;
  for (const auto& piece : c.pieces) {
    skew = skew || (c.model == Model::shell && !plate_bending(piece.fabric).is_symmetric());
    narrow = narrow && is_narrow(piece.cloth);
  }
  if (name == "auto") return named(skew ? "lu" : narrow ? "cholesky" : "cg", c.model);
  return named(name, c.model);
}

std::unique_ptr<LinearSolver> sensitivity_solver(const Case& c) {
  auto solver = dynamics_solver(c);
  if (solver->symmetry() == Symmetry::unsymmetric) return solver;
  return std::make_unique<RefinedSolver>(std::move(solver));
}

RelaxationOptions relaxation_options(const Case& c, const CaseModel& model) {
  const auto& r = c.relaxation;
  auto o = relaxation_options(model.size, model.gravity);
  o.tolerance = r.tolerance;
  o.max_iterations = r.max_iterations.value_or(o.max_iterations);
  o.first_step = r.first_step.value_or(o.first_step);
  o.growth = r.growth;
  o.force_scale = model.force_scale();
  o.largest_rise = 0.05 * o.force_scale * model.size;
  return o;
}

std::unique_ptr<LinearSolver> statics_solver(const Case& c, const System& system) {
  const auto& name = c.relaxation.linear_solver;
  if (name != "auto") return named(name, c.model);
  if (!system.has_symmetric_tangent()) return make_linear_solver(SolverKind::lu);
  return std::make_unique<TurningSolver>(conjugate_gradients(c.model, iterations_worth_a_factorisation),
                                         make_linear_solver(SolverKind::cholesky));
}

}  // namespace sundrape

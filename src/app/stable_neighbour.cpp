#include "sundrape/app/stable_neighbour.hpp"

#include <cmath>

#include "sundrape/app/solver_choice.hpp"
#include "sundrape/statics/stability.hpp"

namespace sundrape {
namespace {

constexpr int most_pushes = 4;
constexpr double push = 1e-3;  // of the sheet's size

}  // namespace

double neutral_frequency(const CaseModel& model) { return 1e-3 * std::sqrt(model.gravity / model.size); }

StableNeighbour relax_to_stable_neighbour(const Case& c, const CaseModel& model, Vector& q,
                                          RelaxationObserver& observer) {
  const auto& system = *model.system;
  const Vector still = Vector::Zero(q.size());
  StableNeighbour found;
  for (int k = 0;; ++k) {
    Tangent tangent(system, neutral_frequency(model));
    (void)tangent.factor({0, q, still});
    found.pivots = tangent.negative_pivots();
    if (k == most_pushes || found.pivots.value_or(0) == 0) return found;
    const auto mode = unstable_mode(system, tangent);
    if (!mode) return found;
    q += push * model.size * displacements(system, mode->shape);
    const auto solver = statics_solver(c, system);
    const auto result = relax(system, *solver, relaxation_options(c, model), q, observer);
    found.result.iterations += result.iterations;
    found.result.factorizations += result.factorizations;
    found.result.linear_iterations += result.linear_iterations;
    found.result.residual = result.residual;
    found.result.end = result.end;
    found.result.diagnosis = result.diagnosis;
    if (result.end != RelaxationEnd::converged) return found;
  }
}

}  // namespace sundrape

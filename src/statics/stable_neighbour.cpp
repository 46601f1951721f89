#include "sundrape/statics/stable_neighbour.hpp"

#include "sundrape/statics/stability.hpp"

namespace sundrape {
namespace {

constexpr int most_pushes = 4;

}  // namespace

StableNeighbour relax_to_stable_neighbour(const System& system, LinearSolver& solver, const RelaxationOptions& options,
                                          double push, double neutral_frequency, Vector& q,
                                          RelaxationObserver& observer) {
  const Vector still = Vector::Zero(q.size());
  Tangent tangent(system, neutral_frequency);
  StableNeighbour found;
  found.result.residual =
      relative_residual(system, {options.load_factor, q, still, options.stage}, options.force_scale);
  for (int k = 0;; ++k) {
    (void)tangent.factor({options.load_factor, q, still, options.stage});
    found.pivots = tangent.negative_pivots();
    if (k == most_pushes || found.pivots.value_or(0) == 0) return found;
    const auto mode = unstable_mode(system, tangent);
    if (!mode) return found;
    q += push * displacements(system, mode->shape);
    found.result = after(found.result, relax(system, solver, options, q, observer));
    if (found.result.end != RelaxationEnd::converged) return found;
  }
}

StableNeighbour relax_until_stable(const System& system, LinearSolver& solver, const RelaxationOptions& options,
                                   double push, double neutral_frequency, Vector& q, RelaxationObserver& observer) {
  const auto first = relax(system, solver, options, q, observer);
  if (first.end != RelaxationEnd::converged) return {first, {}};
  auto found = relax_to_stable_neighbour(system, solver, options, push, neutral_frequency, q, observer);
  found.result = after(first, std::move(found.result));
  return found;
}

}  // namespace sundrape

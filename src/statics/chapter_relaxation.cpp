#include "sundrape/statics/chapter_relaxation.hpp"

#include <fmt/format.h>

#include "sundrape/linalg/power_iteration.hpp"

namespace sundrape {
namespace {

double stiffest(const System& system, const Vector& q, const Vector& still) {
  BlockMatrix matrix(system.structure(), Symmetry::symmetric);
  matrix.set_zero();
  system.add_tangent({0, q, still}, -1, 0, matrix);
  for (const auto& [row, component] : system.unknowns().held_components()) matrix.hold(row, component, 0);
  return largest_eigenvalue(matrix, Vector::Ones(system.unknowns().rows()));
}

}  // namespace

RelaxationResult relax_as_in_chapter(const System& system, const ChapterRelaxationOptions& options, Vector& q, RelaxationObserver& observer) {
  const auto& unknowns = system.unknowns();
  const Vector still = Vector::Zero(q.size());
  Vector f(q.size()), rows(unknowns.size()), rows_q(unknowns.size()), displacement = Vector::Zero(unknowns.size());
  unknowns.gather(q, rows_q);
  // the power iteration comes from below, hence the margin
  const double c_disp = options.c_disp > 0 ? options.c_disp : 0.9 / stiffest(system, q, still);
  const double c_acc = options.c_acc >= 0 ? options.c_acc : 0.9 / c_disp;

  RelaxationResult result;
  for (;;) {
    system.force({0, q, still}, f);
    unknowns.gather(f, rows);
    unknowns.clear_held(rows);
    displacement = c_disp * (rows + c_acc * displacement);
    rows_q += displacement;
    unknowns.scatter(rows_q, q);
    ++result.iterations;
    double largest = 0;
    for (int r = 0; r < unknowns.rows(); ++r) largest = std::max(largest, point(displacement, r).norm());
    const bool converged = largest < options.edge_length / 10000;
    if (!rows_q.allFinite()) {
      result.end = RelaxationEnd::stalled;
      result.diagnosis = fmt::format("the chapter's scheme has blown up after {} steps: lower relaxation.c_disp (now {:.3g} m/N)", result.iterations, c_disp);
      return result;
    }
    if (converged || result.iterations % options.report_every == 0) {
      result.residual = relative_residual(system, {0, q, still}, options.force_scale);
      observer.step({static_cast<double>(result.iterations), q, still}, {.iteration = result.iterations, .time = static_cast<double>(result.iterations), .step_size = 1, .residual = result.residual});
      if (observer.wants_to_stop()) {
        result.end = RelaxationEnd::stopped;
        return result;
      }
    }
    if (converged) return result;
    if (result.iterations >= options.max_iterations) {
      result.end = RelaxationEnd::stalled;
      result.diagnosis = fmt::format("the chapter's scheme still moves nodes by {:.3g} m a step after {} steps (it stops below {:.3g} m): use "
                                     "relaxation.scheme = \"implicit\"",
                                     largest, result.iterations, options.edge_length / 10000);
      return result;
    }
  }
}

}  // namespace sundrape

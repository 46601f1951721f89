#include "sundrape/statics/chapter_relaxation.hpp"

#include <fmt/format.h>

#include "sundrape/system/largest_eigenvalue.hpp"

namespace sundrape {
ChapterRelaxationResult relax_as_in_chapter(const System& system, const ChapterRelaxationOptions& options, Vector& q,
                                            RelaxationObserver& observer) {
  constexpr int residual_every = 20;  // steps; it costs two evaluations of the forces
  const auto& unknowns = system.unknowns();
  const Vector still = Vector::Zero(q.size());
  Vector f(q.size()), rows(unknowns.size()), rows_q(unknowns.size()), displacement = Vector::Zero(unknowns.size());
  unknowns.gather(q, rows_q);
  double c_disp = options.c_disp;
  if (!(c_disp > 0))  // the power iteration comes from below, hence the margin
    c_disp = 0.9 / largest_eigenvalue(system, {0, q, still}, -1, 0, Vector::Ones(unknowns.rows()));
  const double c_acc = options.c_acc >= 0 ? options.c_acc : 0.9 / c_disp;

  ChapterRelaxationResult result;
  const auto stall = [&](std::string diagnosis) {
    result.end = RelaxationEnd::stalled;
    result.diagnosis = std::move(diagnosis);
    return result;
  };
  for (;;) {
    system.force({0, q, still}, f);
    unknowns.gather(f, rows);
    unknowns.clear_held(rows);
    displacement = c_disp * (rows + c_acc * displacement);
    rows_q += displacement;
    unknowns.scatter(rows_q, q);
    ++result.iterations;
    if (!rows_q.allFinite())
      return stall(
          fmt::format("the chapter's scheme has blown up after {} steps: lower relaxation.c_disp (now {:.3g} m/N)",
                      result.iterations, c_disp));
    double largest = 0;
    for (int r = 0; r < unknowns.rows(); ++r) largest = std::max(largest, point(displacement, r).norm());
    const bool small = largest < options.edge_length / 10000, first_small = small && result.criterion_iterations == 0;
    if (first_small || result.iterations % residual_every == 0)
      result.residual = relative_residual(system, {0, q, still}, options.force_scale);
    if (first_small) {
      result.criterion_iterations = result.iterations;
      result.criterion_residual = result.residual;
    }
    const bool converged = small && result.iterations % residual_every == 0 && result.residual <= options.tolerance;
    if (converged || result.iterations % options.report_every == 0) {
      const auto count = static_cast<double>(result.iterations);
      observer.step({count, q, still},
                    {.iteration = result.iterations, .time = count, .step_size = 1, .residual = result.residual});
      if (observer.wants_to_stop()) {
        result.end = RelaxationEnd::stopped;
        return result;
      }
    }
    if (converged) return result;
    if (result.iterations >= options.max_iterations)
      return stall(
          fmt::format("the chapter's scheme has residual {:.3g} (tolerance {:.3g}) after {} steps: use "
                      "relaxation.scheme = \"implicit\"",
                      result.residual, options.tolerance, result.iterations));
  }
}

}  // namespace sundrape

#include "sundrape/statics/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sundrape {
namespace {

constexpr double largest_jump = 300;    // of the residual in one step
constexpr double cut = 0.5;             // of the step after a refusal
constexpr double smallest_step = 1e-9;  // [s]
constexpr double largest_step = 1e4;    // [s]; M/h² is then far below any stiffness, yet holds neutral rigid motion

/// The out-of-balance force over the unknowns and the point where it is largest.
class OutOfBalance {
 public:
  OutOfBalance(const System& system, double force_scale)
      : system_(system),
        force_scale_(force_scale),
        still_(Vector::Zero(3 * system.mass().size())),
        f_(still_),
        rows_(system.unknowns().size()) {}

  /// Returns the residual relative to the external force.
  double evaluate(const Vector& q) {
    const State all{0, q, still_};
    system_.force(all, f_);
    system_.unknowns().gather(f_, rows_);
    system_.unknowns().clear_held(rows_);
    const double external = system_.external_force_norm(all);
    return rows_.norm() / (external > 0 ? external : force_scale_);
  }
  [[nodiscard]] const Vector& rows() const { return rows_; }
  [[nodiscard]] const Vector& still() const { return still_; }
  [[nodiscard]] int worst_point() const {
    int worst = 0;
    double largest = -1;
    for (int r = 0; r < system_.unknowns().rows(); ++r)
      if (const double size = point(rows_, r).norm(); size > largest) {
        largest = size;
        worst = system_.unknowns().point_of_row()[static_cast<std::size_t>(r)];
      }
    return worst;
  }

 private:
  const System& system_;
  double force_scale_;
  Vector still_, f_, rows_;
};

}  // namespace

double relative_residual(const System& system, const State& all, double force_scale) {
  const auto& unknowns = system.unknowns();
  const State still{all.time, all.q, Vector::Zero(all.v.size()), all.stage};
  Vector f(all.q.size()), rows(unknowns.size());
  system.force(still, f);
  unknowns.gather(f, rows);
  unknowns.clear_held(rows);
  const double external = system.external_force_norm(still);
  return rows.norm() / (external > 0 ? external : force_scale);
}

RelaxationOptions relaxation_options(double size, double gravity) {
  RelaxationOptions options;
  options.first_step = 0.01 * std::sqrt(size / gravity);
  options.largest_move = size / 40;
  return options;
}

RelaxationResult relax(const System& system, LinearSolver& solver, const RelaxationOptions& options, Vector& q,
                       RelaxationObserver& observer) {
  const auto& unknowns = system.unknowns();
  const auto n = unknowns.size();
  BlockMatrix matrix(system.structure(), solver.symmetry());
  solver.analyse(system.structure());
  OutOfBalance balance(system, options.force_scale);
  Vector v = Vector::Zero(n), rows_q(n), step(n), right_side(n), tried = q;
  unknowns.gather(q, rows_q);

  RelaxationResult result;
  result.residual = balance.evaluate(q);
  double h = options.first_step, time = 0;
  for (; result.residual > options.tolerance; ++result.iterations) {
    const auto stall = [&](const std::string& why, const std::string& advice) {
      result.end = RelaxationEnd::stalled;
      result.diagnosis = fmt::format(
          "{} after {} iterations: residual {:.3g} (tolerance {:.3g}), largest out-of-balance force at node {}; {}",
          why, result.iterations, result.residual, options.tolerance, balance.worst_point(), advice);
      return result;
    };
    if (result.iterations >= options.max_iterations)
      return stall("relaxation has not converged",
                   "raise relaxation.max_iterations, or look at the last frame: something may slide freely");

    RelaxationStep report{.iteration = result.iterations + 1};
    const Vector force = balance.rows();
    if (force.dot(v) < 0) v.setZero();
    double move = 0;  // of the node that moves furthest [m]
    for (;; ++report.refused, h *= cut) {
      if (h < smallest_step)
        return stall("relaxation cannot take any step", "two nodes may coincide, or a contact may be far too stiff");
      matrix.set_zero();
      matrix.add_diagonal(system.row_mass(), 1 / (h * h));
      system.add_tangent({0, q, balance.still()}, -1, 0, matrix);
      system.hold(matrix);
      ++result.factorizations;
      if (solver.factor(matrix) != FactorStatus::ok) continue;
      right_side = force;
      for (int r = 0; r < unknowns.rows(); ++r) point(right_side, r) += system.row_mass()[r] / h * point(v, r);
      unknowns.clear_held(right_side);
      if (!solver.solve(right_side, step, 1e-8).ok || !step.allFinite() || step.dot(right_side) <= 0) continue;
      move = step.cwiseAbs().maxCoeff();
      if (options.largest_move > 0 && move > options.largest_move) continue;
      tried = q;
      unknowns.scatter(rows_q + step, tried);
      const double residual = balance.evaluate(tried);
      if (!std::isfinite(residual) || residual > largest_jump * result.residual) continue;
      result.residual = residual;
      break;
    }
    q = tried;
    rows_q += step;
    v = step / h;
    time += h;
    report.time = time;
    report.step_size = h;
    report.residual = result.residual;
    for (int r = 0; r < unknowns.rows(); ++r) report.kinetic += 0.5 * system.row_mass()[r] * point(v, r).squaredNorm();
    Vector all_v = Vector::Zero(q.size());
    unknowns.scatter(v, all_v);
    observer.step({time, q, all_v}, report);
    if (observer.wants_to_stop()) {
      result.end = RelaxationEnd::stopped;
      ++result.iterations;
      return result;
    }
    // a step that grows moves between h and h² further
    const double room = options.largest_move > 0 ? std::sqrt(0.9 * options.largest_move / move) : options.growth;
    h = std::min(h * std::min(options.growth, room), largest_step);
  }
  return result;
}

}  // namespace sundrape

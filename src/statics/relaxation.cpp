#include "sundrape/statics/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sundrape {
namespace {

constexpr double cut = 0.5;             // of the step after a refusal
constexpr double shortened = 0.999;     // of the largest move: safely below it in spite of round-off
constexpr int most_halvings = 6;        // of a move whose energy rises
constexpr double progress = 0.9;        // of the residual
constexpr int patience = 300;           // iterations without progress; from then on no step overshoots
constexpr double overshot = 0.8;        // of the force along a step, that it turns around
constexpr double smallest_step = 1e-9;  // [s]
constexpr double largest_step = 1e4;    // [s]; M/h² is then far below any stiffness, yet holds neutral rigid motion

/// The out-of-balance force over the unknowns and the point where it is largest.
class OutOfBalance {
 public:
  OutOfBalance(const System& system, const RelaxationOptions& options)
      : system_(system),
        force_scale_(options.force_scale),
        load_factor_(options.load_factor),
        stage_(options.stage),
        still_(Vector::Zero(3 * system.mass().size())),
        f_(still_),
        rows_(system.unknowns().size()) {}

  /// Returns the residual relative to the external force.
  double evaluate(const Vector& q) {
    const State all = state(q);
    system_.force(all, f_);
    system_.unknowns().gather(f_, rows_);
    system_.unknowns().clear_held(rows_);
    const double external = system_.external_force_norm(all);
    return rows_.norm() / (external > 0 ? external : force_scale_);
  }
  [[nodiscard]] const Vector& rows() const { return rows_; }
  [[nodiscard]] State state(const Vector& q) const { return {load_factor_, q, still_, stage_}; }
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
  double force_scale_, load_factor_;
  int stage_;
  Vector still_, f_, rows_;
};

}  // namespace

RelaxationResult after(const RelaxationResult& first, RelaxationResult second) {
  second.iterations += first.iterations;
  second.factorizations += first.factorizations;
  second.linear_iterations += first.linear_iterations;
  return second;
}

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
  long of_structure = system.structures();
  solver.analyse(system.structure());
  OutOfBalance balance(system, options);
  Vector v = Vector::Zero(n), rows_q(n), step(n), right_side(n), force(n), tried = q, all_v = Vector::Zero(q.size());
  unknowns.gather(q, rows_q);

  RelaxationResult result;
  result.residual = balance.evaluate(q);
  std::optional<Passage> passage;  // that the last step tried would have meant
  double h = options.first_step, time = 0, least_residual = result.residual;
  int least_at = 0;
  bool goes_round = false;
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

    if (result.residual < progress * least_residual) {
      least_residual = result.residual;
      least_at = result.iterations;
    }
    goes_round = goes_round || result.iterations > least_at + patience;

    RelaxationStep report{.iteration = result.iterations + 1};
    force = balance.rows();
    if (force.dot(v) < 0) v.setZero();
    right_side = force;
    const double digits = std::clamp(0.1 * result.residual, 1e-8, 1e-2);
    /// Newton's step from M/h² + K; false if there is none, or it does not go downhill.
    const auto find_step = [&] {
      if (const long now = system.adapt(balance.state(q)); now != of_structure) {
        of_structure = now;
        matrix = BlockMatrix(system.structure(), solver.symmetry());
        solver.analyse(system.structure());
      }
      matrix.set_zero();
      matrix.add_diagonal(system.row_mass(), 1 / (h * h));
      system.add_tangent(balance.state(q), -1, 0, matrix);
      system.hold(matrix);
      ++result.factorizations;
      if (solver.factor(matrix) != FactorStatus::ok) return false;
      for (int r = 0; r < unknowns.rows(); ++r)
        point(right_side, r) = point(force, r) + system.row_mass()[r] / h * point(v, r);
      unknowns.clear_held(right_side);
      const auto solved = solver.solve(right_side, step, digits);
      result.linear_iterations += solved.iterations;
      return solved.ok && step.allFinite() && step.dot(right_side) > 0;
    };
    /// Takes the step, or as much of it as the limits allow. The energy's rise is the work against the mean of the
    /// forces at both ends, which needs no potential.
    const auto take_step = [&] {
      const double move = step.cwiseAbs().maxCoeff();
      if (options.largest_move > 0 && move > options.largest_move) step *= shortened * options.largest_move / move;
      for (int halving = 0; halving <= most_halvings; ++halving, step *= 0.5) {
        tried = q;
        unknowns.scatter(rows_q + step, tried);
        passage = system.passage(balance.state(q), balance.state(tried));
        if (passage) continue;
        const double residual = balance.evaluate(tried);
        const double rise = -0.5 * step.dot(force + balance.rows());
        if (!std::isfinite(residual) || (options.largest_rise > 0 && rise > options.largest_rise)) continue;
        // Newton's steps across a contact's edge may go to and fro for ever
        if (goes_round && halving < most_halvings && residual > progress * result.residual &&
            step.dot(balance.rows()) < -overshot * step.dot(force))
          continue;
        result.residual = residual;
        return true;
      }
      return false;
    };
    passage.reset();
    double move = 0;  // that Newton's step asked for, of the node that moves furthest [m]
    for (;; ++report.refused, h *= cut) {
      if (h < smallest_step && passage)
        return stall(describe(*passage) + ", however small the step: relaxation cannot go on",
                     "look whether supports press layers into each other");
      if (h < smallest_step)
        return stall("relaxation cannot take any step", "two nodes may coincide, or a contact may be far too stiff");
      if (!find_step()) continue;
      move = step.cwiseAbs().maxCoeff();
      if (take_step()) break;
    }
    q = tried;
    rows_q += step;
    v = step / h;
    time += h;
    report.time = time;
    report.step_size = h;
    report.load_factor = options.load_factor;
    report.residual = result.residual;
    for (int r = 0; r < unknowns.rows(); ++r) report.kinetic += 0.5 * system.row_mass()[r] * point(v, r).squaredNorm();
    unknowns.scatter(v, all_v);
    observer.step({time, q, all_v}, report);
    if (observer.wants_to_stop()) {
      result.end = RelaxationEnd::stopped;
      ++result.iterations;
      return result;
    }
    // a step that grows moves between h and h² further
    const double room =
        options.largest_move > 0 ? std::max(std::sqrt(0.9 * options.largest_move / move), cut) : options.growth;
    h = std::min(h * std::min(options.growth, room), largest_step);
  }
  return result;
}

}  // namespace sundrape

#pragma once
#include <functional>
#include <string>
#include <utility>

#include "sundrape/linalg/linear_solver.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape {

struct RelaxationOptions {
  double tolerance = 1e-6;  // on |out-of-balance force| / |external force|
  int max_iterations = 2000;
  double first_step = 1e-3;  // [s]
  double growth = 1.5;       // of the step from one iteration to the next
  double largest_move = 0;   // of a node in one iteration [m], so that none jumps through an obstacle; 0: no limit
  double largest_rise = 0;   // of the potential energy in one iteration [J]; 0: no limit
  double force_scale = 0;    // compared with instead of the external force where there is none [N]
  int stage = 0;             // of staged statics: at which loads; 0: full ones
  double load_factor = 0;    // in that stage
};

/// Options for a sheet of a size [m] under a gravity [m/s²]: a first step of 0.01 √(L/g), moves of at most L/40.
[[nodiscard]] RelaxationOptions relaxation_options(double size, double gravity);

/// One accepted (or refused) iteration.
struct RelaxationStep {
  int iteration = 0;
  double time = 0, step_size = 0;  // of the fictitious motion [s]
  double residual = 0;             // |out-of-balance force| / |external force|
  double kinetic = 0;              // [J]
  double load_factor = 0;          // at which loads, supports and obstacles stand
  int refused = 0;                 // tries that this step took beyond the first
};

class RelaxationObserver {
 public:
  virtual ~RelaxationObserver() = default;
  virtual void step(const State& all, const RelaxationStep& step) = 0;
  [[nodiscard]] virtual bool wants_to_stop() = 0;
};

/// A relaxation that nobody looks at; it can be stopped where a way to ask is given.
class UnseenRelaxation final : public RelaxationObserver {
 public:
  explicit UnseenRelaxation(std::function<bool()> wants_to_stop = [] { return false; })
      : wants_to_stop_(std::move(wants_to_stop)) {}
  void step(const State& /*all*/, const RelaxationStep& /*step*/) override {}
  [[nodiscard]] bool wants_to_stop() override { return wants_to_stop_(); }

 private:
  std::function<bool()> wants_to_stop_;
};

enum class RelaxationEnd { converged, stopped, stalled };

struct RelaxationResult {
  RelaxationEnd end = RelaxationEnd::converged;
  int iterations = 0;
  int factorizations = 0;     // complete or incomplete, refused ones included
  int linear_iterations = 0;  // of an iterative solver
  double residual = 0;
  std::string diagnosis;  // why it stalled and what to try
};

/// The result of a relaxation that went on where another one ended: its end, and the counts of both.
[[nodiscard]] RelaxationResult after(const RelaxationResult& first, RelaxationResult second);

/// Finds an equilibrium by damped motion whose steps grow until they are Newton's.
///
/// Each iteration is a linearly implicit Euler step of the undamped system, (M/h² + K) Δq = f(q) + M v/h, v = Δq/h,
/// with kinetic damping: rates are zeroed when the force does negative work on them. h grows by `growth`. A step is
/// refused and h cut where the matrix is not positive definite, and shortened where a node would move further than
/// `largest_move` or the energy would rise by more than `largest_rise`. While M/h² matters the motion is downhill, so
/// it leaves saddles (but not a symmetric path: start from a wavy sheet); when it no longer does, the last steps
/// converge quadratically. Iterative solvers are asked for a hundredth of the right side, and for more digits as the
/// residual falls.
[[nodiscard]] RelaxationResult relax(const System& system, LinearSolver& solver, const RelaxationOptions& options,
                                     Vector& q, RelaxationObserver& observer);

/// |Σ f| over the unknowns, relative to the external force (or force_scale where that vanishes).
[[nodiscard]] double relative_residual(const System& system, const State& all, double force_scale);

}  // namespace sundrape

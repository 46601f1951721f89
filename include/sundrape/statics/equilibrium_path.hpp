#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sundrape/statics/relaxation.hpp"
#include "sundrape/statics/stability.hpp"
#include "sundrape/statics/staged_equilibrium.hpp"

namespace sundrape {

/// What is held while Newton's method looks for the next equilibrium: the length of the step along the path, so that it
/// passes limit points, or the load.
enum class PathControl { arc_length, load };

/// What to do where the path bifurcations.
enum class AtBifurcation { pass, switch_branch, stop };

struct PathOptions {
  PathControl control = PathControl::arc_length;
  int stages = 1;
  double tolerance = 1e-6;    // on |out-of-balance force| / |loads|
  int target_iterations = 7;  // N_p of (20)
  bool accelerate = true;     // γ_n = N_p/N_{n−1}; else every step of a stage is as long as its first
  std::vector<double> first_increment{2.5e-4};  // of the load factor, one a stage; the last one goes for the rest
  int max_iterations = 30;                      // in one step
  int max_steps = 1000;                         // accepted
  double size = 1;                              // L [m]: increments of coordinates count over it
  double largest_move = 0;                      // of a node in the prediction of a step [m]; 0: no limit
  double neutral_frequency = 1e-2;              // ε of the tangent [1/s]
  double force_scale = 0;                       // see StagedEquilibrium [N]
  bool fall = false;                  // where stability is lost, to the next stable equilibrium under the same load
  double push = 0;                    // along the unstable mode, to fall [m]
  RelaxationOptions relaxation = {};  // for the fall
  AtBifurcation at_bifurcation = AtBifurcation::pass;
  int branch = 1;               // which bifurcation: 1, the first, and so on
  double branch_amplitude = 0;  // first move along the mode, signed [m]
};

/// Where on a path one is, with what going on takes.
struct PathPosition {
  int stage = 1;
  double load_factor = 0;
  Vector q = {};       // all points, 3P [m]
  Vector step_q = {};  // last accepted step, 3P [m]; zero at the start of a stage
  double step_load = 0;
  double arc_length = 0;    // of that step, in units of (19), lengths over L; 0 at the start of a stage
  int step_iterations = 0;  // N_{n−1} of (20)
  int bifurcations = 0;     // bifurcations so far
  long steps = 0, iterations = 0, factorizations = 0;
};

/// One accepted step.
struct PathStep {
  int iterations = 0, halvings = 0;    // corrections, and how often the step was halved
  double residual = 0;                 // |out-of-balance force| / |loads|
  std::optional<int> negative_pivots;  // of the tangent at its end
};

/// A state at which the tangent is singular: a limit point of the load, or a bifurcation of the path.
struct CriticalPoint {
  enum class Kind { limit_point, bifurcation };
  Kind kind = Kind::bifurcation;
  int stage = 1;
  double load_factor = 0, uncertainty = 0;  // ± of the load factor
  Vector q;                                 // 3P [m]
  Vector mode;                              // 3P, its largest displacement 1
  int pivots_before = 0, pivots_after = 0;
};

class PathObserver {
 public:
  virtual ~PathObserver() = default;
  virtual void step(const PathPosition& at, const PathStep& step) = 0;
  /// A residual on the way to the next equilibrium; iteration 1 is the prediction.
  virtual void iteration(const PathPosition& from, int iteration, double load_factor, double residual) = 0;
  virtual void critical_point(const CriticalPoint& point) = 0;
  /// Something that happened on the way.
  virtual void remark(const std::string& text) = 0;
  /// Something that casts doubt on the path from here on.
  virtual void warn(const std::string& text) = 0;
  [[nodiscard]] virtual bool wants_to_stop() = 0;
};

enum class PathEnd { complete, stopped, stalled, at_bifurcation };

struct PathResult {
  PathEnd end = PathEnd::complete;
  std::string diagnosis;  // why it stalled and what to try
};

/// Follows equilibria while loads and supports change, stage by stage, from `at` to the end of the last stage: the
/// adaptive arc-length method of the chapter (§2.2.1, §2.2.3; Schweizerhof and Wriggers 1986), or load steps by
/// Newton's method with a line search.
///
/// A step begins with the prediction Δλ u^I, u^I = K⁻¹F_0, of length γ_n Δs and in the sense of the step before, and is
/// corrected by (21) and (22) to equilibrium at that distance (19). Lengths count over L, so that the path does not
/// depend on the unit; the minus that (19) lacks is put in; γ multiplies the last step's length, since a factor on the
/// first one could never reach the paper's 1994 steps in 45. Where a step diverges it is halved (4.1).
/// Negative pivots are counted at every step; where they change the critical point between is located.
/// Two signs that a step may have jumped to another branch are warned of: a change of pivots that no critical point on
/// the way explains, and, where the step's length was not held (the first one of a stage, and load control), a move
/// three times as far as predicted, or a residual that rises again and again (by which the article tells its buckling
/// mode).
[[nodiscard]] PathResult follow_path(const System& system, const PathOptions& options, PathPosition& at,
                                     PathObserver& observer);

}  // namespace sundrape

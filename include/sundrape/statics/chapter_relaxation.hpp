#pragma once
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

struct ChapterRelaxationOptions {
  double c_disp = 0;        // displacement per force [m/N]; 0: 0.9/λ, λ the largest eigenvalue of K at the start
  double c_acc = -1;        // pseudo-force per displacement of the last step [N/m]; < 0: 0.9 / c_disp
  double edge_length = 0;   // b [m]
  double tolerance = 1e-6;  // on |out-of-balance force| / |external force|
  int max_iterations = 1000000;
  int report_every = 1000;
  double force_scale = 0;  // as in RelaxationOptions
};

struct ChapterRelaxationResult : RelaxationResult {
  int criterion_iterations = 0;   // steps after which the chapter's own criterion first held; 0: never
  double criterion_residual = 0;  // and the residual there
};

/// The chapter's own scheme (§3.2): every node moves by C_disp times its resultant force, to which C_acc times its last
/// displacement is added (49). A baseline to show what relaxing by implicit steps saves.
///
/// The chapter stops when no node moves further than b/10,000 in a step (§3.2.3). A small C_disp meets that far from
/// equilibrium, so the scheme goes on to the residual that other schemes are asked for, and reports both.
[[nodiscard]] ChapterRelaxationResult relax_as_in_chapter(const System& system, const ChapterRelaxationOptions& options,
                                                          Vector& q, RelaxationObserver& observer);

}  // namespace sundrape

#pragma once
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

struct ChapterRelaxationOptions {
  double c_disp = 0;          // displacement per force [m/N]; 0: 1/λ of the stiffest mode of the start, which is stable
  double c_acc = -1;          // pseudo-force per displacement of the last step [N/m]; < 0: 0.9 / c_disp
  double edge_length = 0;     // b [m]: converged when no node moves further than b/10,000 in a step
  int max_iterations = 2000000;
  int report_every = 1000;
  double force_scale = 0;     // as in RelaxationOptions
};

/// The chapter's own scheme (§3.2): every node moves by C_disp times its resultant force, to which C_acc times its last
/// displacement is added (49), until displacements are small (§3.2.3). A baseline to show what relaxing by implicit
/// steps saves; its criterion says little about the residual, which is reported.
[[nodiscard]] RelaxationResult relax_as_in_chapter(const System& system, const ChapterRelaxationOptions& options, Vector& q, RelaxationObserver& observer);

}  // namespace sundrape

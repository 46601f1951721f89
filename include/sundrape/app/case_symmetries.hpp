#pragma once
#include <optional>
#include <span>
#include <vector>

#include "sundrape/app/model.hpp"
#include "sundrape/system/point_map.hpp"

namespace sundrape {

/// Rigid motions that change no force and no support: how far a sheet has slid or turned on its table says nothing of
/// its shape.
struct NeutralMotions {
  std::vector<Vector3> slides;   // horizontal unit directions, orthogonal, 0 to 2
  std::optional<Vector3> pivot;  // of turns about the vertical, z [m]

  [[nodiscard]] bool any() const { return !slides.empty() || pivot.has_value(); }
};

/// What may be done to a state of a case without making it another answer.
struct CaseSymmetries {
  std::vector<PointMap> maps;  // the identity first
  NeutralMotions neutral;
};

/// The symmetries of a case, found by trying: of the sheet's own symmetries, placed as the sheet is, those that leave
/// the supports as they are and that the total force follows, f(g q) = g f(q), to 1e-6 of it at every trial state;
/// and each of these after a mirror of space that is none of theirs (an upright plane through what is held, or through
/// the middle of the sheet, an obstacle or a support), if the case has one: a tilted sheet that hangs from two points.
///
/// The trial states are the start under small and under large random displacements, and the given states under
/// small ones: forces of obstacles that none of them touches are not seen.
/// @param visited  states of all points, 3P each [m]; end states are the ones to give
[[nodiscard]] CaseSymmetries find_case_symmetries(const CaseModel& model, std::span<const Vector> visited = {});

}  // namespace sundrape

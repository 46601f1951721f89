#pragma once
#include <optional>
#include <vector>

#include "sundrape/app/model.hpp"

namespace sundrape {

/// A case on a coarser mesh of the same sheet, and its mechanics.
struct CoarserCase {
  Case c;
  CaseModel model;
};

/// Coarser and coarser versions of a case, the finest first: rectangles, discs and annuli with half the cells each way.
///
/// Each has the same supports and loads: what a selector picks on the coarse mesh are nodes of the fine one, or it is a
/// set that any mesh of the shape has, such as an edge. The last one resolves folds just so: the edges of a net are up
/// to a bending length (B/w)^(1/3) long, those of a shell a third of it. Empty for imported meshes, for meshes of less
/// than 300 nodes and where no coarser mesh has the same supports.
[[nodiscard]] std::vector<CoarserCase> coarser_cases(const Case& c, const CaseModel& model);

}  // namespace sundrape

#pragma once
#include <vector>

#include "sundrape/io/case.hpp"

namespace sundrape {

/// The nodes that a selector of a case picks, ascending; at least one.
/// @param placed  where they stand at the start, N
/// @throws CaseError  a set that the mesh does not have; none is picked
[[nodiscard]] std::vector<int> pick(const Selector& selector, const QuadMesh& mesh, const std::vector<Vector3>& placed,
                                    const SourceLine& source);

}  // namespace sundrape

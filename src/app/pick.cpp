#include "pick.hpp"

#include "sundrape/io/case_error.hpp"

namespace sundrape {

std::vector<int> pick(const Selector& selector, const QuadMesh& mesh, const std::vector<Vector3>& placed,
                      const SourceLine& source) {
  std::vector<int> nodes;
  try {
    nodes = select(selector, mesh, placed);
  } catch (const std::invalid_argument& problem) {
    throw CaseError(source, problem.what());
  }
  if (nodes.empty()) throw CaseError(source, "selects no node of the cloth");
  return nodes;
}

}  // namespace sundrape

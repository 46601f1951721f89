#pragma once
#include <vector>

#include "sundrape/app/model.hpp"
#include "sundrape/io/result_reader.hpp"

namespace sundrape {

/// A sheet as a result left it.
struct ShapeAtRest {
  std::vector<Vector3> positions;  // N [m]
  std::vector<Vector3> directors;  // N, of length 1 within their stiffness; empty where the result has none
};

/// The last frame of a result on the mesh.
/// @throws FileError  another mesh (but for waviness at rest), no frame, or positions that are not finite
[[nodiscard]] ShapeAtRest last_shape(const ResultReader& result, const QuadMesh& mesh);

/// The same as a state of all points of a model, 3P [m]; a shell's directors go with the nodes' normals where the
/// result has none.
/// @throws FileError  as last_shape
[[nodiscard]] Vector last_state(const ResultReader& result, const CaseModel& model);

}  // namespace sundrape

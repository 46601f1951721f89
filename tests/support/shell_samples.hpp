#pragma once
#include <memory>
#include <vector>

#include "sundrape/force/director_length.hpp"
#include "sundrape/force/shell.hpp"
#include "sundrape/material/fabric.hpp"
#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// A small shell for tests: cotton twill on any mesh, directors of length ℓ = 3 mm as points N … 2N − 1.
struct ShellSample {
  static constexpr double director_length = 0.003;  // [m]

  QuadMesh mesh;
  std::vector<Vector3> directors;  // at rest
  std::unique_ptr<Shell> shell;
  std::unique_ptr<DirectorLength> length;
  double membrane = 0, bending = 0;  // E h [N/m], B [N m]

  /// Positions, then directors times ℓ.
  [[nodiscard]] std::vector<Vector3> points() const;
};

struct ShellSampleOptions {
  MembraneField membrane = MembraneField::centre;
  CurvatureMeasure curvature = CurvatureMeasure::geodesic;
  enum class Law { isotropic, orthotropic, energy, paper } law = Law::isotropic;
  double poisson = 0.3;
  double membrane_damping = 0, bending_damping = 0;  // [s]
};

[[nodiscard]] ShellSample shell_sample(const QuadMesh& mesh, const ShellSampleOptions& options);

/// 3 × 2 cells of about 1 cm, distorted in their plane, on a saddle if `curved`.
[[nodiscard]] QuadMesh distorted_patch(bool curved);

}  // namespace sundrape

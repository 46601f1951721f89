#pragma once
#include <array>
#include <optional>
#include <vector>

#include "sundrape/material/plate_bending.hpp"
#include "sundrape/mesh/quad_mesh.hpp"
#include "sundrape/types.hpp"

namespace sundrape {

/// How the membrane strains of an element are sampled (docs/shell.md).
enum class MembraneField {
  centre,     // at the centre, with light stiffness of the γ-projected hourglass modes
  bilinear,   // at the 2×2 points of integration: locks where a sheet bends oblique to its mesh
  edge_tied,  // tied at the middles of the edges: fails the patch test of distorted meshes
  mixed,      // assumed stresses of Pian and Sumihara, the mixed field of Simo, Fox and Rifai (chapter A.4.4)
};

/// How curvatures κ₁₁, κ₂₂ follow from directors.
enum class CurvatureMeasure {
  chord,     // φ,α · t,β (17): 2 sin(Δ/2)/a for a turn of Δ over an element of length a
  geodesic,  // times (Δ/2)/sin(Δ/2): exact for circles
};

/// What the sheet is made of, as an element sees it.
struct ShellSection {
  Eigen::Matrix3d membrane = Eigen::Matrix3d::Zero();  // n = C ε in warp–weft axes, engineering shear [N/m]
  double shear = 0;                                    // κ G_s h, the correction factor counted once (20), (22) [N/m]
  PlateBending bending;                                // [N m]
  double membrane_damping = 0;  // Kelvin–Voigt relaxation time of membrane and transverse shear [s]
  double bending_damping = 0;   // [s]
};

/// One quadrilateral at rest. Points are counted counter-clockwise from (ξ, η) = (−1, −1).
struct ShellElement {
  std::array<int, 4> nodes{}, directors{};    // points of positions, and of directors
  std::array<Vector3, 4> position, director;  // at rest [m], [-]
  std::array<Eigen::Vector2d, 4> material;    // warp and weft coordinates [m]
  double hourglass_factor = 0.1;              // of the centre field
  bool spans = false;                         // reaches from one edge of the sheet to the other
};

/// The elements of a mesh whose node i is point i and whose director i is point N + i.
/// @param directors         unit, N
/// @param hourglass_factor  by default 0.1, and 1 in elements that span the sheet between two of its edges, which
///                          would otherwise be soft in their plane
[[nodiscard]] std::vector<ShellElement> shell_elements(const QuadMesh& mesh, const std::vector<Vector3>& directors,
                                                       std::optional<double> hourglass_factor = {});

}  // namespace sundrape

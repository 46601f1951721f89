#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "sundrape/force/force_term.hpp"
#include "sundrape/force/load_course.hpp"
#include "sundrape/force/shell_gauges.hpp"
#include "sundrape/io/case.hpp"
#include "sundrape/mesh/quad_mesh.hpp"
#include "sundrape/mesh/threads.hpp"
#include "sundrape/system/unknowns.hpp"

#include "pieces.hpp"

namespace sundrape {

/// What holds the nodes of a sheet.
struct Supports {
  explicit Supports(std::size_t nodes) : position(nodes), director(nodes), clamped(nodes, false) {}

  /// Of all points of the sheet.
  [[nodiscard]] std::vector<Unknowns::Held> of_points(bool has_directors) const {
    auto held = position;
    if (has_directors) held.insert(held.end(), director.begin(), director.end());
    return held;
  }

  std::vector<Unknowns::Held> position, director;  // N; directors of a shell only
  std::vector<bool> clamped;                       // N: slopes of a particle net
};

/// The cloth itself, all pieces of it, as points, masses and force terms: of a particle net its nodes, of a shell its
/// nodes, then its directors.
struct Sheet {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  Vector mass;                      // P [kg]; of directors rotary inertia over ℓ², 0 where they have none
  std::vector<int> order;           // in which points become unknowns, P
  double director_length = 0;       // ℓ [m]; 0 of a particle net
  std::vector<ShellGauges> gauges;  // of a shell, one a piece
  std::vector<Vector3> directors;   // where the sheet was placed, N; empty of a particle net

  [[nodiscard]] int points() const { return static_cast<int>(mass.size()); }
};

[[nodiscard]] Sheet net_sheet(const Case& c, const Cloth& cloth, const Threads& threads, const Supports& supports);
/// @throws CaseError  elements that are not convex
[[nodiscard]] Sheet shell_sheet(const Case& c, const Cloth& cloth);

/// A moment [N m] on nodes of a sheet, shared by tributary length of the boundary between them; of a shell equally
/// where there is none.
/// @throws std::invalid_argument  of a particle net: no boundary edge between the nodes, or no thread that ends there
[[nodiscard]] std::unique_ptr<ForceTerm> moment_load(const Sheet& sheet, const QuadMesh& mesh, const Threads& threads,
                                                     const std::vector<int>& nodes, const Vector3& total,
                                                     LoadCourse course);

}  // namespace sundrape

#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sundrape/force/bend_springs.hpp"
#include "sundrape/force/clamp_springs.hpp"
#include "sundrape/force/cloth_contact.hpp"
#include "sundrape/force/director_length.hpp"
#include "sundrape/force/obstacle_contact.hpp"
#include "sundrape/force/shell_gauges.hpp"
#include "sundrape/io/case.hpp"
#include "sundrape/io/result.hpp"
#include "sundrape/mesh/edge_strains.hpp"
#include "sundrape/mesh/joined.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape {

/// A case made into mechanics: its mesh, its system, and what results want to know about them.
struct CaseModel {
  struct ReactionSet {
    std::string name;
    std::vector<int> nodes;
    std::optional<std::size_t> motion = {};  // of the system, where what it holds changes in time
  };
  /// A support that takes hold, or lets go, in time: a motion of the system.
  struct Gripper {
    std::string name;
    Selector nodes;
    GripCase grip;
    SourceLine source;
    bool moves = false;  // along a path
    bool turns = false;  // holds directors too; of a net's clamps those that it has from the start
    std::size_t motion = 0;
    std::vector<int> at_start = {};  // the nodes that it holds then
  };

  QuadMesh mesh;
  std::vector<MeshPiece> pieces;  // of it
  RigidPlacement placement;       // rest shape to initial position
  std::unique_ptr<System> system;
  Vector initial;    // placed and wavy positions, then directors times ℓ, 3P [m]
  Vector node_area;  // tributary areas at rest, N [m²]
  EdgeStrains edge_strains;
  double director_length = 0;  // ℓ of a shell, whose node i has the director point N + i [m]; 0 of a particle net
  Vector rate_slack;           // how many times larger the errors of rates may be: rows, n; empty: 1
  const ObstacleContact* contact = nullptr;     // owned by the system; null without obstacles
  const ClothContact* cloth_contact = nullptr;  // owned by the system; null where cloth may pass through cloth
  SheetSurface surface;                         // of the mesh
  const DirectorLength* directors = nullptr;    // owned by the system; null of a particle net
  std::vector<ClampSprings*> clamps;            // owned by the system
  std::vector<const BendSprings*> bends;  // owned by the system; measured laws of warp and weft are terms of their own
  std::vector<ShellGauges> gauges;        // of a shell, one a piece
  std::vector<ReactionSet> reactions;
  std::vector<Gripper> grippers;
  std::vector<bool> clamped_for_good;  // N: whether the slope of a net's node is held to the end
  std::vector<ProbeRecord> probes;
  std::vector<ObstacleRecord> obstacles;
  bool has_inertia = false;  // dynamics: what supports carry has to be accelerated
  double size = 0;           // longest side of the rest shape's bounding box, of several that of the largest [m]
  double gravity = 0;        // |acceleration| [m/s²]; 9.80665 where there is no gravity
  double weight = 0;         // mass times |gravity load| [N]
  double area_weight = 0;    // of the fabric under `gravity` [N/m²]

  /// What forces are compared with where nothing loads the cloth [N].
  [[nodiscard]] double force_scale() const { return area_weight * size * size; }
  /// Whether anything rubs.
  [[nodiscard]] bool has_friction() const {
    return (contact != nullptr && contact->has_friction()) ||
           (cloth_contact != nullptr && cloth_contact->options().friction > 0);
  }
  /// Of all nodes under `gravity`, whether that acts or not [N].
  [[nodiscard]] double nominal_weight() const { return system->mass().head(mesh.nodes()).sum() * gravity; }

  [[nodiscard]] bool has_directors() const { return director_length > 0; }
  /// The part of a vector of all points that belongs to the nodes, 3N.
  [[nodiscard]] Vector of_nodes(const ConstVectorRef& all) const {
    return all.head(3 * static_cast<Eigen::Index>(mesh.nodes()));
  }
  /// One number a point, those of directors added to their nodes', N.
  [[nodiscard]] Vector folded(const Vector& of_points) const;
  /// The nodes that a support holds now.
  [[nodiscard]] const std::vector<int>& nodes_of(const ReactionSet& set) const {
    return set.motion ? system->motion(*set.motion).points : set.nodes;
  }
  /// The points of nodes' directors that a gripper holds too.
  [[nodiscard]] std::vector<int> turned_points(const Gripper& gripper, const std::vector<int>& nodes) const;
  /// Directors, 3N [-]; empty without them.
  [[nodiscard]] Vector directors_of(const ConstVectorRef& all) const;
};

/// @throws CaseError  what only shows with the mesh at hand: selectors that pick nothing, sets that are not there,
/// loads
///                    that find no edge, supports in conflict, a mesh that cannot be used
/// @param friction  how it enters tangents: by the secant, for Newton's iteration, or as it is
[[nodiscard]] CaseModel build_model(const Case& c, FrictionMatrix friction = FrictionMatrix::secant);

[[nodiscard]] RigidPlacement placement(const Place& place);

/// Where points of the rest shape stand once the sheet is placed [m]: what selectors look at.
[[nodiscard]] std::vector<Vector3> place(const std::vector<Vector3>& rest, const Place& place);

/// Whether a case's waviness is one of the rest shape, rather than of the start alone.
[[nodiscard]] bool is_wavy_at_rest(const Case& c, const PieceCase& piece);

/// Amplitude of the waviness that relaxation starts from unless the case says otherwise [m]: a flat symmetric sheet
/// ends on a saddle.
[[nodiscard]] double default_waviness(const PieceCase& piece);

/// What the cloth exerts on the nodes of a set: what nothing in the system balances.
struct Reaction {
  Vector3 force;   // [N]
  Vector3 moment;  // about the mean position of the nodes, couples of clamped slopes and directors included [N m]
};
[[nodiscard]] Reaction reaction(const CaseModel& model, const State& all, const std::vector<int>& nodes);

}  // namespace sundrape

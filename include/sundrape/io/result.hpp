#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"
#include "sundrape/mesh/triangle_mesh.hpp"
#include "sundrape/types.hpp"

/// What a result consists of, for those who write it and those who read it. SI units throughout.
namespace sundrape {

enum class ResultStatus { running, done, failed, interrupted };
[[nodiscard]] std::string to_string(ResultStatus status);

/// What the frames are numbered by.
enum class FrameVariable { time, load_factor };

/// A rigid obstacle, as a viewer needs it.
struct ObstacleRecord {
  std::string name, kind;                                 // kind: plane, box, cylinder, sphere, capsule, disc, mesh
  std::map<std::string, std::vector<double>> parameters;  // its shape, by the names of the case file, SI
  Vector3 position = Vector3::Zero();                     // [m]
  Matrix3 rotation = Matrix3::Identity();                 // shape to world
  double friction = 0;                                    // coefficient
  bool moves = false;                                     // frames say where it is
  TriangleMesh surface = {};                              // of a mesh; else empty
};

/// An obstacle at one instant.
struct ObstaclePose {
  Vector3 position = Vector3::Zero();  // [m]
  Matrix3 rotation = Matrix3::Identity();
  Vector3 force = Vector3::Zero();  // on the cloth [N]
};

struct ProbeRecord {
  std::string name;
  int node = -1;  // of the mesh
};

/// One column of /steps. Those that the layout knows need a name only.
struct StepColumn {
  std::string name, units, description;
  bool integer = false;
};
/// @throws std::invalid_argument  a name that the layout does not know
[[nodiscard]] StepColumn step_column(const std::string& name);
/// time, step_size, order, newton_iterations, linear_iterations, error_test_failures, convergence_failures, contacts.
[[nodiscard]] std::vector<StepColumn> dynamics_step_columns();
/// time, step_size, residual, newton_iterations, linear_iterations, contacts, negative_pivots.
[[nodiscard]] std::vector<StepColumn> relaxation_step_columns();
/// load_factor, stage, arc_length, newton_iterations, halvings, residual, contacts, negative_pivots.
[[nodiscard]] std::vector<StepColumn> path_step_columns();

/// A parameter that frames hold derivatives by.
struct SensitivityRecord {
  std::string parameter;  // key of the case
  double value = 0;       // SI
  std::string unit;       // SI; "1": a plain number
};

/// What is known before the first frame.
struct ResultHeader {
  std::string title, model, analysis;
  std::string case_text;  // the TOML as run, --set included
  std::string inputs;     // fingerprints of the other files that it read
  std::string version;    // of sundrape
  QuadMesh mesh;
  FrameVariable frame_variable = FrameVariable::time;
  bool director = false;               // whether frames hold directors
  bool element_fields = false;         // whether frames hold strains and stress resultants of elements
  std::uint64_t expected_frames = 64;  // space is set aside for so many; more may follow
  std::vector<std::string> reaction_sets;
  std::vector<ProbeRecord> probes;
  std::vector<StepColumn> step_columns;  // the first one counts the steps
  std::vector<ObstacleRecord> obstacles;
  std::vector<SensitivityRecord> sensitivities;
  bool rate_sensitivities = false;  // whether velocities have derivatives too
};

/// The energy balance at one instant [J].
struct FrameEnergies {
  double kinetic = 0, membrane = 0, shear = 0, bending = 0, gravity = 0, contact = 0;  // stored
  double dissipated = 0;         // turned into heat by the physics so far
  double external_work = 0;      // done by loads without an energy and by prescribed motion so far
  double method_dissipated = 0;  // lost (> 0) or gained (< 0) by the time integration itself so far
};

/// Strains and stress resultants at the centres of a shell's elements in warp–weft axes, element by element.
struct ElementFields {
  Vector membrane_strain;  // 3E: ε₁₁, ε₂₂, 2ε₁₂
  Vector membrane_force;   // 3E: n₁₁, n₂₂, n₁₂ [N/m]
  Vector shear_strain;     // 2E: γ₁, γ₂
  Vector shear_force;      // 2E: q₁, q₂ [N/m]
  Vector curvature;        // 3E: κ₁₁, κ₂₂, 2κ₁₂ [1/m]
  Vector moment;           // 3E: m₁₁, m₂₂, m₁₂ [N]
};

/// Derivatives by one parameter, per SI unit of it.
struct FrameSensitivity {
  Vector position, velocity;  // 3N; velocity where the header says so
};

/// One frame. Vectors of 3N hold three components a node.
struct Frame {
  double variable = 0;        // time [s] or load factor
  int stage = 0;              // that the load factor is of
  Vector position, velocity;  // 3N [m], [m/s]
  Vector contact_force;       // 3N, on the cloth [N]; may be empty: zeros
  Vector director;            // 3N, where the header says so
  Vector energy_density;      // N, what the cloth stores by its deformation over its area [J/m²]; may be empty: zeros
  ElementFields elements;     // where the header says so
  FrameEnergies energies;
  double residual = 0;                          // |out-of-balance force| / |external force|
  int negative_pivots = -1;                     // of the tangent; −1: not evaluated
  double penetration = 0;                       // deepest, into an obstacle or of cloth into cloth [m]
  std::int64_t crossings = 0;                   // pairs of triangles of the cloth that intersect
  std::vector<Vector3> reactions;               // force that the cloth exerts on each reaction set [N]
  std::vector<Vector3> moments;                 // its moment about the mean position of the set's nodes [N m]
  std::vector<FrameSensitivity> sensitivities;  // one a parameter of the header; may be empty: NaN, not known
  std::vector<ObstaclePose> obstacles;          // one an obstacle of the header; may be empty: as there, without forces
};

/// Where an equilibrium path has a limit point or forks.
struct CriticalRecord {
  bool limit_point = false;
  int stage = 1;
  double load_factor = 0, uncertainty = 0;  // ±
  int pivots_before = 0, pivots_after = 0;
  Vector position, mode;  // 3N [m]; [-], the largest displacement of a node or director 1
};

using StatisticValue = std::variant<std::int64_t, double, std::string>;
struct Statistic {
  std::string name;
  StatisticValue value;
  std::string description;
};

/// What an analysis needs to go on from an instant: arrays that it names, and how much of the result belongs to them.
struct Checkpoint {
  std::map<std::string, std::vector<double>> arrays;
  std::uint64_t frames = 0, steps = 0, probe_rows = 0, warnings = 0;  // filled in by the writer
  std::uint64_t iterations = 0, critical_points = 0;                  // of an equilibrium path; likewise
};

}  // namespace sundrape

#pragma once
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sundrape/force/wind_field.hpp"
#include "sundrape/io/key_table.hpp"
#include "sundrape/material/fabric.hpp"
#include "sundrape/mesh/rigid_path.hpp"
#include "sundrape/mesh/selector.hpp"
#include "sundrape/types.hpp"

namespace sundrape {

/// Where in the case something stands, for errors that only show once the mesh is known.
struct SourceLine {
  std::string file = {};  // as the user gave it; "--set key=value" for what the command line says
  int line = 0;           // 0: from --set
  std::string key = {};   // dotted: "fix.0.nodes", "output.probes.1.near", "load.0"
};

struct Place {  // rest -> placed: rotate about the origin, then translate
  Vector3 translate = Vector3::Zero();
  Vector3 axis = Vector3::UnitZ();
  double angle = 0;  // [rad]
};

enum class Model { particle, shell };
enum class Analysis { dynamics, relaxation, arc_length };
/// As a case file calls it.
[[nodiscard]] std::string to_string(Analysis analysis);

// [m], warp direction first
struct RectangleShape {
  double length = 0, width = 0;
  int cells_warp = 0, cells_weft = 0;
};

// cells across the diameter
struct DiscShape {
  double radius = 0;
  int cells = 0;
};

struct AnnulusShape {
  double inner_radius = 0, outer_radius = 0;
  int cells_radial = 0, cells_around = 0;
};

// OBJ of quads, scaled to metres; absolute path
struct MeshShape {
  std::filesystem::path file;
  double unit = 1;
  SourceLine source;
};

// A result whose last frame is where the cloth starts; absolute path
struct StartCase {
  std::filesystem::path file;
  SourceLine source;
};

struct ClothCase {
  std::variant<RectangleShape, DiscShape, AnnulusShape, MeshShape> shape;
  Place place;
  std::optional<StartCase> start;      // instead of the placed rest shape
  double waviness_amplitude = 0;       // [m], out of plane, uniform in ± amplitude at every node
  std::optional<bool> waviness_given;  // whether the case says so itself
  unsigned waviness_seed = 1;
  std::optional<bool> waviness_at_rest;  // whether the rest shape is wavy too; default: in arc-length
};

/// When nodes are held: dynamics only.
struct GripCase {
  std::optional<double> from;   // gripped where they are then [s]; else from the start
  std::optional<double> until;  // let go [s]

  [[nodiscard]] bool always() const { return !from && !until; }
};

struct FixCase {
  std::string name;  // of its reaction in the result; from the selector unless given
  Selector nodes;
  std::array<bool, 3> components{true, true, true};
  std::array<bool, 3> director{true, true, true};  // components of a shell node's director; all with `rotation`
  bool rotation = true;                            // the slope: of a particle net's edge, or the whole director
  GripCase grip = {};
  SourceLine source;  // of the selector
};

// [m/s²]
struct GravityLoad {
  Vector3 acceleration{0, 0, -9.80665};
};

// [N], shared equally
struct ForceLoad {
  Selector nodes;
  Vector3 total;
};

// [N m], shared by tributary length
struct MomentLoad {
  Selector nodes;
  Vector3 total;
};

// [N/m] of edge
struct TractionLoad {
  Selector nodes;
  Vector3 per_length;
};

// [Pa], follows the face normal
struct PressureLoad {
  double value = 0;
};

struct WindLoad {
  WindField field;
  AirCoefficients air;
};

struct LoadCase {
  std::variant<GravityLoad, ForceLoad, MomentLoad, TractionLoad, PressureLoad, WindLoad> load;
  double ramp = 0;                // reaches full size smoothly over this time [s]
  std::vector<double> stages{1};  // shares of the load at the ends of the stages of arc-length
  SourceLine source;              // of the selector where it has one
};

/// A path, and when it is travelled.
struct PathCase {
  RigidPath path;
  double start = 0;                     // [s]
  std::optional<double> duration = {};  // [s]; of keyframes by their times
  bool smooth = true;                   // starts and stops smoothly
  std::vector<double> stages{1};        // shares of the path at the ends of the stages of arc-length

  [[nodiscard]] double end() const { return start + duration.value_or(0); }  // [s]
};

/// Nodes carried along a path.
struct MotionCase {
  std::string name;  // of its reaction in the result; from the selector unless given
  Selector nodes;
  std::array<bool, 3> components{true, true, true};
  bool rotation = false;  // the gripped edge turns with the path; else it is a hinge
  PathCase course;
  GripCase grip = {};
  SourceLine source;  // of the selector
};

struct PlaneShape {
  Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();
};

// full edge lengths [m]
struct BoxShape {
  Vector3 size;
  double edge_radius = 0;
};

struct CylinderShape {
  double radius = 0, length = 0;
  Vector3 axis = Vector3::UnitZ();
  double edge_radius = 0;
};

struct SphereShape {
  double radius = 0;
};

// length between the cap centres
struct CapsuleShape {
  double radius = 0, length = 0;
  Vector3 axis = Vector3::UnitZ();
};

// its top is z = 0 of its place
struct DiscPedestalShape {
  double radius = 0, height = 0;
  double edge_radius = 0;
};

// a closed surface of triangles, scaled to metres; absolute path
struct MeshBodyShape {
  std::filesystem::path file;
  double unit = 1;
  std::optional<double> voxel;  // [m]; default: a 64th of its largest size
  SourceLine source;
};

struct ObstacleCase {
  std::string name;
  std::variant<PlaneShape, BoxShape, CylinderShape, SphereShape, CapsuleShape, DiscPedestalShape, MeshBodyShape> shape;
  Place place;                     // where it stands at the start
  std::optional<PathCase> motion;  // from there
  double friction = 0;             // coefficient of Coulomb's friction
  SourceLine source;
};

struct ContactCase {
  bool self = false;                  // cloth touches cloth
  double friction = 0;                // coefficient of Coulomb's friction of cloth on cloth
  std::optional<double> stiffness;    // pressure per depth [N/m³]; default from the load and the penetration allowed
  int subdivision = 2;                // contact points cut the sides of a cell into so many parts; 1: nodes alone
  double smoothing = 0;               // distance over which the force sets in [m]; default 0.1 thickness
  double penetration = 0;             // allowed [m]; default 0.1 thickness
  std::optional<double> restitution;  // in [0, 1]; absent: no impact law
  double restitution_speed = 0.05;    // impacts slower than this are left to the penalty force [m/s]
  double friction_speed = 1e-4;       // below which friction is viscous instead of holding [m/s]
  bool thickness_given = false;       // by the case, for all pieces of cloth alike
  double thickness = 0;               // at which distance layers lie on each other [m]; default the material's, the
                                      // mean of two
};

enum class IntegratorKind { cvode, ida, rk4, dirk };

struct DynamicsCase {
  IntegratorKind integrator = IntegratorKind::cvode;
  double duration = 0;  // [s]
  double rtol = 1e-4;
  std::optional<double> atol_position;  // [m]; default 0.25 rtol L
  std::optional<double> atol_velocity;  // [m/s]; default 0.01 √(g L)
  int max_order = 2;
  std::optional<double> step, max_step, first_step;  // [s]
  std::string linear_solver = "auto";                // auto | cg | cholesky | lu
  std::optional<double> time_limit;                  // wall clock [s]
  std::optional<double> until_rest;                  // kinetic energy over weight times size below which it rests
};

struct RelaxationCase {
  std::vector<double> times;        // ascending, at which to look for equilibrium where supports or obstacles move [s]
  double tolerance = 1e-6;          // on |out-of-balance force| / |external force|
  std::string scheme = "implicit";  // implicit | chapter
  bool continuation = true;         // from coarser meshes, where there are any
  std::optional<int> max_iterations;  // default 2000; of the chapter's scheme 1,000,000
  std::optional<double> first_step;   // [s]
  double growth = 1.5;
  std::string linear_solver = "auto";
  bool relax_unstable = false;       // an unstable end, to the stable equilibrium next to it
  std::optional<double> c_disp;      // [m/N] of the chapter's scheme; default: a safe one from the stiffest mode
  std::optional<double> c_acc;       // [N/m]
  std::optional<double> time_limit;  // wall clock [s]
};

enum class PathControlKind { arc_length, load };
enum class BifurcationKind { pass, switch_branch, stop };

struct ArcLengthCase {
  double tolerance = 1e-6;  // on |out-of-balance force| / |external force|
  PathControlKind control = PathControlKind::arc_length;
  int target_iterations = 7;                    // N_p
  std::vector<double> first_increment{2.5e-4};  // of the load factor, one a stage
  bool acceleration = true;
  int max_iterations = 30, max_steps = 1000;
  std::optional<double> largest_move;  // of a node in the prediction of a step [m]; default L/10
  bool fall = false;                   // where stability is lost, to the next stable equilibrium
  BifurcationKind at_bifurcation = BifurcationKind::pass;
  int branch = 1;                          // which bifurcation
  std::optional<double> branch_amplitude;  // first move along its mode, signed [m]; default 0.01 L
  bool relax_unstable = false;             // the end, to the stable equilibrium next to it
  int frame_every = 1;                     // steps
  std::optional<double> time_limit;        // wall clock [s]
};

struct ProbeCase {
  std::string name;
  Vector3 near = Vector3::Zero();
  SourceLine source;
};

struct OutputCase {
  std::vector<double> frame_times;  // dynamics: from 0 to the duration
  double checkpoint_every = 2;      // wall clock [s]
  bool resultants = true;           // strains and stress resultants of a shell's elements in every frame
  std::vector<ProbeCase> probes;
};

enum class ShellMembrane { centre, bilinear, edge_tied, mixed };
enum class ShellBending { geodesic, bilinear };
enum class ShellDirector { automatic, inertia, massless };

/// How the shell elements are made, with model = "shell".
struct ShellCase {
  ShellMembrane membrane = ShellMembrane::centre;
  std::optional<double> hourglass_factor;  // default 0.1, and 1 in elements that span the sheet from edge to edge
  ShellBending bending = ShellBending::geodesic;
  double shear_correction = 5.0 / 6;  // κ on G_s h, once
  ShellDirector director = ShellDirector::automatic;
  double rotary_inertia = 1;  // factor on ρ h³/12
};

/// A continuous number of a case that results are differentiated by, or that is identified.
struct ParameterCase {
  std::string key;   // dotted, as for --set
  double value = 0;  // SI
  std::string unit;  // SI; "1": a plain number
  Range range;       // that the key accepts
  SourceLine source;
};

/// A sheet of cloth and what it is made of.
struct PieceCase {
  std::string name = "cloth";
  ClothCase cloth;
  std::string fabric_title;  // empty where the case does not say
  Fabric fabric;
};

/// One case, fully resolved: SI units, defaults filled in, ranges checked. What a reader of case files hands on.
struct Case {
  std::string title;
  Model model = Model::particle;
  ShellCase shell;
  Analysis analysis = Analysis::dynamics;
  std::vector<PieceCase> pieces = std::vector<PieceCase>(1);  // at least one
  std::optional<double> breaking_strain;                      // of an edge: beyond it the cloth counts as torn
  std::vector<FixCase> fixes;
  std::vector<MotionCase> motions;
  std::vector<LoadCase> loads;
  std::vector<ObstacleCase> obstacles;
  ContactCase contact;
  DynamicsCase dynamics;
  RelaxationCase relaxation;
  ArcLengthCase arc_length;
  OutputCase output;
  std::vector<ParameterCase> sensitivities;  // what the run is differentiated by
  std::filesystem::path file;                // the case file; relative paths inside it count from its folder
  std::string text;                          // the TOML as run, --set included
  std::string inputs;                        // fingerprints of the other files that it reads: mesh, start

  /// The first piece: the sheet, of most cases.
  [[nodiscard]] const PieceCase& sheet() const { return pieces.front(); }
  [[nodiscard]] PieceCase& sheet() { return pieces.front(); }

  /// Whether supports or obstacles move.
  [[nodiscard]] bool moves() const {
    return !motions.empty() || std::ranges::any_of(obstacles, [](const auto& o) { return o.motion.has_value(); });
  }
  /// When the last load has reached its full size, the last path has ended and the last gripper has done its work [s].
  [[nodiscard]] double settled_after() const {
    double last = 0;
    for (const auto& load : loads) last = std::max(last, load.ramp);
    const auto changes = [&](const GripCase& grip) {
      last = std::max({last, grip.from.value_or(0), grip.until.value_or(0)});
    };
    for (const auto& fix : fixes) changes(fix.grip);
    for (const auto& motion : motions) changes(motion.grip);
    return std::max(last, end_of_paths());
  }
  [[nodiscard]] double end_of_paths() const {  // [s]; 0 where nothing moves
    double last = 0;
    for (const auto& motion : motions) last = std::max(last, motion.course.end());
    for (const auto& obstacle : obstacles)
      if (obstacle.motion) last = std::max(last, obstacle.motion->end());
    return last;
  }
  /// Stages of arc-length that loads, motions and obstacles name: at least 1.
  [[nodiscard]] int stages() const {
    std::size_t most = 1;
    for (const auto& load : loads) most = std::max(most, load.stages.size());
    for (const auto& motion : motions) most = std::max(most, motion.course.stages.size());
    for (const auto& obstacle : obstacles)
      if (obstacle.motion) most = std::max(most, obstacle.motion->stages.size());
    return static_cast<int>(most);
  }
};

}  // namespace sundrape

#pragma once
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "sundrape/app/model.hpp"
#include "sundrape/integrate/integrator.hpp"
#include "sundrape/statics/relaxation.hpp"

namespace sundrape {

/// A case from cases/ (by file name) with settings, built.
struct Benchmark {
  Case c;
  CaseModel model;
};
[[nodiscard]] Benchmark benchmark(const std::string& case_name, const std::vector<std::string>& sets = {});
/// "cloth.cells=[n,1]", for benchmark().
[[nodiscard]] std::string cells_along(int n);

/// An equilibrium by relaxation: positions of all nodes (3N) and what it took.
struct Equilibrium {
  Vector q;
  RelaxationResult result;
};
/// Fails the test if it does not converge.
[[nodiscard]] Equilibrium equilibrium(const Benchmark& b, double tolerance = 1e-6);
/// From a state of all points, such as the equilibrium under a smaller load (3P).
[[nodiscard]] Equilibrium equilibrium_from(const Vector& start, const Benchmark& b, double tolerance = 1e-6);

/// A dynamic case at its frame times, and what the integrator did.
struct Motion {
  std::vector<double> time;                // [s]
  std::vector<Vector> position, velocity;  // 3N [m], [m/s]
  std::vector<double> energy, kinetic;     // kinetic + stored, and kinetic alone [J]
  IntegratorStatistics statistics;
};
[[nodiscard]] std::unique_ptr<Integrator> integrator_of(const Benchmark& b);
/// From rest in the initial positions.
/// @throws IntegrationFailure
[[nodiscard]] Motion motion(const Benchmark& b);
/// From a state of all nodes (3N), by any integrator, to the last of the frame times.
[[nodiscard]] Motion motion(const System& system, Integrator& integrator, const std::vector<double>& frame_times,
                            ConstVectorRef q, ConstVectorRef v);

/// Nodes of a strip by their place along its warp, from start to end.
[[nodiscard]] std::vector<std::vector<int>> columns(const QuadMesh& strip);
/// Centre line of a strip along its warp, from start to end: means over its width of a vector of all nodes (3N).
[[nodiscard]] std::vector<Vector3> centre_line(const QuadMesh& strip, const Vector& all);
/// Angle by which the last edge of a planar centre line has turned from +x towards +z, followed along the line so that
/// it may pass ±π [rad]; one entry an edge.
[[nodiscard]] std::vector<double> edge_angles(const std::vector<Vector3>& line);
/// Rotation of the tip of a strip [rad], to second order. The last edge has the slope of its middle; over its last half
/// the curvature runs linearly from the mean of those at its ends to `tip_curvature`, what the load on the tip demands
/// [1/m]; that at its inner end is the angle to the edge before over their distance.
[[nodiscard]] double tip_rotation(const std::vector<Vector3>& line, double tip_curvature);

/// Angle by which the directors of a strip of shell elements have turned from +z towards −x, from start to end [rad];
/// followed along the strip so that it may pass ±π. Means over its width of a vector of all points (3P).
[[nodiscard]] std::vector<double> director_angles(const CaseModel& model, const Vector& all);

/// Order of convergence between two meshes, from their errors.
[[nodiscard]] double observed_order(double coarse_error, double fine_error, double refinement = 2);

/// Columns of a reference table (CSV with # comments), by header name.
[[nodiscard]] std::map<std::string, std::vector<double>> reference_table(const std::string& name);

/// Where the end of a cantilever of unit length has gone.
struct Tip {
  double shortening, rise, rotation;  // of the tip, over L; [rad]
  [[nodiscard]] double distance(const Tip& other) const {
    return std::hypot(shortening - other.shortening, rise - other.rise);
  }
};

/// λ = P L²/EI and the tip of the elastica, for λ > 0 (elastica_tip_force.csv).
[[nodiscard]] std::vector<std::pair<double, Tip>> elastica_of_tip_force();
/// λ = M L/(π EI) and the tip of the arc, for λ > 0 (elastica_tip_moment.csv).
[[nodiscard]] std::vector<std::pair<double, Tip>> arcs_of_tip_moment();

}  // namespace sundrape

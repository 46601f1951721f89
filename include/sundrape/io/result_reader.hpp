#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sundrape/io/hdf5.hpp"
#include "sundrape/io/result.hpp"

namespace sundrape {

struct ProbeHistory {
  int node = -1;
  std::vector<double> time;                 // [s], or load factors: one a step
  std::vector<Vector3> position, velocity;  // [m], [m/s]
};

/// Reads a result file, finished or not. Sees what was complete when it was opened.
class ResultReader {
 public:
  /// @throws FileError  missing, not HDF5, not a result of sundrape, or of a newer layout
  explicit ResultReader(const std::filesystem::path& path);

  [[nodiscard]] const std::string& title() const { return title_; }
  [[nodiscard]] const std::string& model() const { return model_; }
  [[nodiscard]] const std::string& analysis() const { return analysis_; }
  [[nodiscard]] const std::string& status() const { return status_; }  // running also after a kill
  [[nodiscard]] const std::string& message() const { return message_; }
  [[nodiscard]] const std::string& version() const { return version_; }
  [[nodiscard]] const std::string& case_text() const { return case_text_; }
  [[nodiscard]] const std::string& inputs() const { return inputs_; }
  [[nodiscard]] const QuadMesh& mesh() const { return mesh_; }

  [[nodiscard]] std::size_t frames() const { return frame_values_.size(); }
  [[nodiscard]] FrameVariable frame_variable() const { return frame_variable_; }
  /// Time [s] or load factor of each frame.
  [[nodiscard]] const std::vector<double>& frame_values() const { return frame_values_; }
  /// 3N. @throws FileError  no such frame
  [[nodiscard]] Vector position(std::size_t frame) const { return nodal("/frames/position", frame); }
  [[nodiscard]] Vector velocity(std::size_t frame) const { return nodal("/frames/velocity", frame); }
  [[nodiscard]] Vector contact_force(std::size_t frame) const { return nodal("/frames/contact_force", frame); }
  [[nodiscard]] bool has_director() const;
  [[nodiscard]] Vector director(std::size_t frame) const { return nodal("/frames/director", frame); }

  [[nodiscard]] bool has_energy_density() const;  // results of older versions have none
  /// N [J/m²].
  [[nodiscard]] Vector energy_density(std::size_t frame) const { return nodal("/frames/energy_density", frame); }

  /// By name (kinetic, membrane, ...), one value a frame [J].
  [[nodiscard]] std::map<std::string, std::vector<double>> energies() const;
  [[nodiscard]] std::vector<double> residual() const;
  [[nodiscard]] std::vector<std::int64_t> negative_pivots() const;
  [[nodiscard]] std::vector<double> penetration() const;                        // [m]
  [[nodiscard]] std::vector<Vector3> contact_force_sum() const;                 // [N]
  [[nodiscard]] std::map<std::string, std::vector<Vector3>> reactions() const;  // by set, one a frame [N]

  /// Of reactions about the mean position of each set's nodes; by set, one a frame [N m]; empty in older results.
  [[nodiscard]] std::map<std::string, std::vector<Vector3>> reaction_moments() const;
  [[nodiscard]] bool has_element_fields() const;
  /// Strains and stress resultants of a shell's elements. @throws FileError  no such frame, or none kept
  [[nodiscard]] ElementFields element_fields(std::size_t frame) const;

  /// By which parameters frames hold derivatives.
  [[nodiscard]] std::vector<SensitivityRecord> sensitivities() const;
  /// d(position)/d(parameter), 3N, NaN where not known. @throws FileError  no such frame or parameter
  [[nodiscard]] Vector position_sensitivity(const std::string& parameter, std::size_t frame) const;

  [[nodiscard]] std::size_t steps() const { return steps_; }
  /// By name, one value a step.
  [[nodiscard]] std::map<std::string, std::vector<double>> step_columns() const;
  [[nodiscard]] std::map<std::string, ProbeHistory> probes() const;
  [[nodiscard]] std::vector<Statistic> statistics() const;
  /// Of an equilibrium path, in the order in which they were met.
  [[nodiscard]] std::vector<CriticalRecord> critical_points() const;
  [[nodiscard]] std::vector<std::string> warnings() const;
  [[nodiscard]] std::vector<ObstacleRecord> obstacles() const;
  /// Where an obstacle that moves is, and the force on the cloth. @throws FileError  no such frame, or it does not move
  [[nodiscard]] ObstaclePose obstacle_pose(const std::string& obstacle, std::size_t frame) const;
  /// The newest checkpoint that is complete.
  [[nodiscard]] std::optional<Checkpoint> checkpoint() const;

  [[nodiscard]] const hdf5::File& file() const { return file_; }

 private:
  [[nodiscard]] Vector nodal(const std::string& path, std::size_t frame) const;
  [[nodiscard]] std::map<std::string, std::vector<Vector3>> by_set(const std::string& group) const;
  [[nodiscard]] std::vector<double> per_frame(const std::string& path) const;
  [[nodiscard]] std::vector<Vector3> vectors(const std::string& path, std::size_t rows) const;
  void read_mesh();

  hdf5::File file_;
  std::string title_, model_, analysis_, status_, message_, version_, case_text_, inputs_;
  QuadMesh mesh_;
  FrameVariable frame_variable_ = FrameVariable::time;
  std::vector<double> frame_values_;
  std::size_t steps_ = 0;
};

}  // namespace sundrape

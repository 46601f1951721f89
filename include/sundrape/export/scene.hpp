#pragma once
#include <string>
#include <vector>

#include "sundrape/export/obstacle_surface.hpp"
#include "sundrape/io/result_reader.hpp"

namespace sundrape {

/// An obstacle as other programs get it.
struct ExportBody {
  std::string name;
  ShadedSurface surface;  // in its own frame
  bool moves = false;
};

/// Where a body stands: x = position + rotation · own.
struct Pose {
  Vector3 position = Vector3::Zero();  // [m]
  Matrix3 rotation = Matrix3::Identity();

  [[nodiscard]] Vector3 operator()(const Vector3& own) const { return position + rotation * own; }
};

/// A field with one number a node.
struct NodalField {
  std::string name, units;
  Vector values;  // N
};

/// One frame of the cloth, with what is derived from its shape.
struct ExportFrame {
  double variable = 0;             // time [s], pseudo-time of a relaxation, or load factor
  std::vector<Vector3> positions;  // N [m]
  std::vector<Vector3> normals;    // N, unit
  std::vector<NodalField> fields;  // in the order of ExportScene::fields
  std::vector<Pose> bodies;        // one a body
};

/// What exports draw of a result: the cloth in some frames, and the obstacles.
class ExportScene {
 public:
  /// @param frames  numbers of the result's frames, in the order in which they are exported
  /// @throws FileError  a result without frames, or one that cannot be read
  ExportScene(const ResultReader& result, std::vector<std::size_t> frames, bool with_obstacles = true);

  [[nodiscard]] const ResultReader& result() const { return result_; }
  [[nodiscard]] const QuadMesh& mesh() const { return result_.mesh(); }
  [[nodiscard]] std::size_t frames() const { return frames_.size(); }
  [[nodiscard]] const std::vector<std::size_t>& frame_numbers() const { return frames_; }
  /// By number in this scene. @throws FileError
  [[nodiscard]] ExportFrame frame(std::size_t k) const;
  [[nodiscard]] std::vector<Vector3> positions(std::size_t k) const;
  [[nodiscard]] double variable(std::size_t k) const { return result_.frame_values().at(frames_.at(k)); }
  /// When frame k is shown [s], from 0 on: time of a motion; a twenty-fifth of a second a frame of statics.
  [[nodiscard]] double shown_at(std::size_t k) const;

  [[nodiscard]] const std::vector<ExportBody>& bodies() const { return bodies_; }
  /// Warp and weft coordinates over the longer of their two extents, from 0 on: texture coordinates without distortion.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& texture() const { return texture_; }
  [[nodiscard]] double texture_unit() const { return texture_unit_; }  // that extent [m]

 private:
  [[nodiscard]] Pose pose(std::size_t body, std::size_t frame) const;

  const ResultReader& result_;
  std::vector<std::size_t> frames_;
  std::vector<ObstacleRecord> obstacles_;
  std::vector<ExportBody> bodies_;
  std::vector<Eigen::Vector2d> texture_;
  double texture_unit_ = 1;
  Vector areas_;  // tributary, N [m²]
};

}  // namespace sundrape

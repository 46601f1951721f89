#pragma once
#include <optional>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// Finds the quad of a mesh at given material coordinates.
class QuadLocator {
 public:
  explicit QuadLocator(const QuadMesh& mesh);  // keeps a reference to the mesh

  struct Place {
    int quad = 0;
    Eigen::Vector2d at;  // in [0, 1]² inside the quad; corner k is at (0,0), (1,0), (1,1), (0,1)
  };
  /// The quad that a point lies in, or that it misses by least: off a boundary by up to a third of a cell, since a fine
  /// mesh fills more of a curved outline than a coarse one. Nothing farther off.
  [[nodiscard]] std::optional<Place> find(const Eigen::Vector2d& point) const;

 private:
  [[nodiscard]] std::optional<Place> in_quad(int quad, const Eigen::Vector2d& point) const;
  [[nodiscard]] Eigen::Vector2i bin_of(const Eigen::Vector2d& point) const;
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(bins_.x()) + static_cast<std::size_t>(x);
  }

  const QuadMesh& mesh_;
  Eigen::Vector2d low_, bin_size_;
  Eigen::Vector2i bins_;
  std::vector<std::vector<int>> quads_;  // whose surroundings meet a bin
};

}  // namespace sundrape

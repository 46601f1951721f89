#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// Finds the point at a place, in time that does not grow with their number: points in a grid of boxes.
class PointLookup {
 public:
  /// @param tolerance  how far from a point its place may be said to be [m], > 0
  PointLookup(std::span<const Vector3> points, double tolerance);

  /// The nearest point within the tolerance.
  [[nodiscard]] std::optional<int> find(const Vector3& place) const;

 private:
  struct Entry {
    std::array<long, 3> box;
    int point;
  };
  [[nodiscard]] std::array<long, 3> box_of(const Vector3& place) const;

  std::vector<Vector3> points_;
  double tolerance_;
  double side_;                 // of a box [m], at least twice the tolerance
  std::vector<Entry> entries_;  // by box
};

}  // namespace sundrape

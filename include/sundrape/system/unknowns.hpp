#pragma once
#include <array>
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// Which points move freely, and how a short vector of unknowns maps to all points and back.
///
/// A point with all three components held leaves the system. A point with some components held stays, as a block row
/// whose held components have the equation "no change", so that blocks stay 3×3. So does a point that is held
/// later, since supports may let go of it again: sparsity and numbering stay as they are.
class Unknowns {
 public:
  using Held = std::array<bool, 3>;
  struct HeldComponent {
    int row, component;
  };

  explicit Unknowns(const std::vector<Held>& held);  // one entry a point
  /// @param order  the points in the order in which they get their rows, P: near ones next to each other keep
  ///               incomplete factors good
  /// @throws std::invalid_argument  an order that does not have every point once
  Unknowns(const std::vector<Held>& held, const std::vector<int>& order);

  [[nodiscard]] int points() const { return static_cast<int>(holders_.size()); }
  [[nodiscard]] int rows() const { return static_cast<int>(point_of_row_.size()); }  // points that are unknown
  [[nodiscard]] Eigen::Index size() const { return 3 * static_cast<Eigen::Index>(rows()); }
  [[nodiscard]] const std::vector<int>& row_of_point() const { return row_of_point_; }  // −1: held for good
  [[nodiscard]] const std::vector<int>& point_of_row() const { return point_of_row_; }
  [[nodiscard]] const std::vector<HeldComponent>& held_components() const { return held_components_; }
  [[nodiscard]] bool is_held(int point, int component) const {
    return holders_[static_cast<std::size_t>(point)][static_cast<std::size_t>(component)] > 0;
  }
  [[nodiscard]] bool is_held(int point) const { return is_held(point, 0) && is_held(point, 1) && is_held(point, 2); }

  /// One support more holds a component, or one less; it is free when none does.
  /// @throws std::invalid_argument  a point without a row; letting go of what is free
  void hold(int point, int component);
  void let_go(int point, int component);

  /// all (3P) → rows (3n)
  void gather(ConstVectorRef all, VectorRef rows) const;
  /// rows (3n) → all (3P); points that are held keep what stands there.
  void scatter(ConstVectorRef rows, VectorRef all) const;
  /// Zeroes the held components of a vector of rows.
  void clear_held(VectorRef rows) const;
  /// Σ a b over the held components of two vectors of all points (3P).
  [[nodiscard]] double held_dot(ConstVectorRef a, ConstVectorRef b) const;

 private:
  void list_held_components();

  std::vector<std::array<unsigned char, 3>> holders_;  // how many supports hold each component
  std::vector<int> row_of_point_, point_of_row_;
  std::vector<HeldComponent> held_components_;
};

}  // namespace sundrape

#pragma once
#include <cstdint>
#include <vector>

#include "sundrape/linalg/compressed_columns.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape {

/// The 6n × 6n matrix of coordinates and rates side by side that CondensedNewton does without: here to show what that
/// saves.
///
/// Compressed by columns with rows ascending. With K = −∂f/∂q and C = −∂f/∂v it has a diagonal in each upper quarter
/// and the pattern of K in each lower one.
class FullSizeMatrix {
 public:
  explicit FullSizeMatrix(const System& system);

  /// K and C at a state of all points, unsymmetric parts included; held components have none.
  void assemble(const State& all);
  /// Newton's matrix [ c I, −I; K, c M + C ] from what was assembled last.
  void fill_newton(double c);
  /// The Jacobian [ 0, I; −M⁻¹ K, −M⁻¹ C ] of ẏ = (v, M⁻¹ f), its zero diagonal stored.
  void fill_jacobian();

  [[nodiscard]] std::int64_t columns() const { return static_cast<std::int64_t>(column_start_.size()) - 1; }
  [[nodiscard]] std::int64_t entries() const { return column_start_.back(); }
  [[nodiscard]] std::vector<std::int64_t>& column_start() { return column_start_; }  // columns() + 1
  [[nodiscard]] std::vector<std::int64_t>& row() { return row_; }                    // entries()
  [[nodiscard]] std::vector<double>& value() { return value_; }                      // entries()

 private:
  /// [ left I, right I; S K, S C ] with a diagonal matrix S, one entry a point.
  void fill(double left, double right, ConstVectorRef scale);

  const System& system_;
  BlockMatrix stiffness_, damping_;
  CompressedColumns stiffness_columns_, damping_columns_;
  std::vector<std::int64_t> column_start_, row_;
  std::vector<double> value_;
};

}  // namespace sundrape

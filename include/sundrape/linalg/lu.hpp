#pragma once
#include <memory>

#include "sundrape/linalg/linear_solver.hpp"

namespace sundrape {

/// Direct solution of any regular system, symmetric or not, by KLU (Davis, Palamadai Natarajan 2010): P R⁻¹ A Q = L U
/// with row scaling, partial pivoting and minimum-degree ordering.
///
/// factor() keeps the pivots of the last factorisation as long as they serve (reciprocal pivot growth and the crude
/// condition number say so) and chooses new ones otherwise. It throws std::invalid_argument for a matrix of another
/// structure than the one analysed.
class Lu final : public LinearSolver {
 public:
  Lu();
  ~Lu() override;

  [[nodiscard]] std::string_view name() const override { return "LU (KLU)"; }
  [[nodiscard]] Symmetry symmetry() const override { return Symmetry::unsymmetric; }
  void analyse(const BlockStructure& structure) override;
  [[nodiscard]] FactorStatus factor(const BlockMatrix& matrix) override;
  [[nodiscard]] SolveReport solve(ConstVectorRef b, VectorRef x, double tolerance,
                                  double largest = std::numeric_limits<double>::infinity()) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  bool factored_ = false;
};

}  // namespace sundrape

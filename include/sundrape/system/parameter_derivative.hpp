#pragma once
#include <vector>

#include "sundrape/system/system.hpp"

namespace sundrape {

/// The forces of every term of a system at one state: what differences by all its parameters start from.
class TermForces {
 public:
  explicit TermForces(const System& system);

  /// Of the state `all` of the system, whose unknowns count: what is held stands where the system holds it.
  void evaluate(const State& all);
  /// Sum of the terms, 3P [N].
  [[nodiscard]] const Vector& sum() const { return sum_; }

 private:
  friend class ParameterDerivative;

  const System& system_;
  double time_ = 0;
  int stage_ = 0;
  Vector rows_q_, rows_v_;       // 3n
  Vector q_, v_, sum_;           // 3P
  std::vector<Vector> of_term_;  // 3P each
};

/// How the forces, masses and supports of a system change with a parameter p that it was made from.
///
/// One more system, made from p + ε|p|, is asked at the same unknowns, and every derivative is a difference, per
/// relative change of p:  |p| ∂f/∂p ≈ (f₊ − f)/ε.  That is wrong by ε/2 of the second derivative and by rounding over
/// ε, both around 1e-7 of what a term changes by. Forces are differenced term by term, so that what does not depend on
/// p cancels to the last bit: a membrane a million times stiffer than bending leaves no rounding in the derivative by a
/// rigidity.
///
/// Points that are held stand where each of the two systems holds them.
class ParameterDerivative {
 public:
  /// ε: places change by less than what contact smooths over, and the square root of rounding is a tenth of it.
  static constexpr double relative_change = 1e-7;

  /// Of the same points, unknowns and terms; references are kept.
  /// @throws std::invalid_argument  the systems differ in these
  ParameterDerivative(const System& system, const System& changed);

  /// |p| ∂f/∂p over the unknowns, 3n [N], the supports' part in it included.
  /// @param here  the system's forces at the state in question
  void force(const TermForces& here, VectorRef rows);
  /// |p| dM/dp, n [kg].
  [[nodiscard]] const Vector& row_mass() const { return row_mass_; }
  /// |p| d/dp of the coordinates and rates of what is held, 3P; zero elsewhere.
  void supports(double time, int stage, VectorRef q, VectorRef v);

 private:
  const System &system_, &changed_;
  Vector row_mass_;
  Vector rows_q_, rows_v_;                // 3n
  Vector q_, v_, changed_q_, changed_v_;  // 3P
  Vector force_, difference_;             // 3P
};

}  // namespace sundrape

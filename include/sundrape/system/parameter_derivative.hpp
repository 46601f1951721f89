#pragma once
#include "sundrape/system/system.hpp"

namespace sundrape {

/// How the forces, masses and supports of a system change with a parameter p that it was made from.
///
/// Two more systems, made from p − ε|p| and p + ε|p|, are asked at the same unknowns, and every derivative is their
/// central difference, per relative change of p:  |p| ∂f/∂p ≈ (f₊ − f₋)/(2ε).  That is exact up to rounding for what
/// is linear or quadratic in p, and else wrong by ε²/6 of the third derivative. Forces are differenced term by term, so
/// that what does not depend on p cancels to the last bit: a membrane a million times stiffer than bending leaves no
/// rounding in the derivative by a rigidity.
///
/// Points that are held stand where each of the two systems holds them.
class ParameterDerivative {
 public:
  /// ε: far above rounding, and ε² far below any accuracy wanted.
  static constexpr double relative_change = 1e-4;

  /// Of the same points, unknowns and terms; references are kept.
  /// @throws std::invalid_argument  the systems differ in these
  ParameterDerivative(const System& lower, const System& upper);

  /// |p| ∂f/∂p over the unknowns, 3n [N], the supports' part in it included; `all` is of the system itself, of which
  /// the unknowns count.
  void force(const State& all, VectorRef rows);
  /// |p| dM/dp, n [kg].
  [[nodiscard]] const Vector& row_mass() const { return row_mass_; }
  /// |p| d/dp of the coordinates and rates of what is held, 3P; zero elsewhere.
  void supports(double time, int stage, VectorRef q, VectorRef v);

 private:
  /// All points of one of the two systems at the unknowns in rows_q_, rows_v_, with what it holds where it holds it.
  void place(const System& system, double time, int stage, Vector& q, Vector& v);

  const System &lower_, &upper_;
  Vector row_mass_;
  Vector rows_q_, rows_v_;                        // 3n
  Vector lower_q_, lower_v_, upper_q_, upper_v_;  // 3P
  Vector lower_f_, upper_f_, sum_;                // 3P
};

}  // namespace sundrape

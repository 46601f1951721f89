#pragma once
#include <deque>
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// Which polynomial a BDF method predicts with.
enum class BdfForm {
  cvode,  // of order k: through the last k values, with the rate at the last one (CVODE's Nordsieck array)
  ida     // through the last k + 1 values (IDA's divided differences)
};

/// The step equation of a variable-step BDF method in fixed-leading-coefficient form, as CVODE and IDA take it:
///     ẏ_n = c y_n − g,   c = (1 + 1/2 + … + 1/k)/h,   g = c π(t_n) − π'(t_n),
/// π being the polynomial that predicts y_n from what has been. Linear in y, so that the derivative of a discrete
/// solution by a parameter obeys the same equation with the derivatives' own history (internal numerical
/// differentiation). Times and steps are the integrator's; many vectors may share them.
class BdfHistory {
 public:
  BdfHistory(BdfForm form, int max_order) : form_(form), max_order_(max_order) {}

  /// Nothing has been before this time.
  void restart(double time);
  /// The step that the integrator has just taken, of which c() and the weights of g are wanted.
  void begin_step(double time, double step_size, int order);
  [[nodiscard]] double c() const { return c_; }

  /// One vector's past values, newest first, and its rate at the newest.
  struct Past {
    std::deque<Vector> values;
    Vector rate;
  };
  /// g of the step that has begun.
  [[nodiscard]] Vector g(const Past& past) const;
  /// What the method predicts for y_n.
  [[nodiscard]] Vector predicted(const Past& past) const;
  /// Takes y_n and ẏ_n = c y_n − g into the past.
  void accept(const Vector& y, const Vector& g, Past& past) const;
  /// Ends the step, once every vector has been accepted.
  void end_step();
  /// y at a time within the last step: the polynomial of the method there.
  [[nodiscard]] Vector at(double time, const Past& past) const;

 private:
  struct Weights {
    Vector values;    // of past values, newest first
    double rate = 0;  // of the newest rate
  };
  /// Weights of a polynomial's value and slope at a time, as α π(t) + β π'(t).
  [[nodiscard]] Weights weights(int order, double time, double alpha, double beta) const;
  [[nodiscard]] static Vector apply(const Weights& weights, const Past& past);

  BdfForm form_;
  int max_order_;
  std::deque<double> times_;  // of past values, newest first
  double time_ = 0, step_ = 0, c_ = 0;
  int order_ = 1;
  Weights g_;
};

}  // namespace sundrape

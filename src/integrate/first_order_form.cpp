#include "sundrape/integrate/first_order_form.hpp"

namespace sundrape {

FirstOrderForm::FirstOrderForm(const System& system) : system_(system) {
  const auto all = 3 * static_cast<Eigen::Index>(system.unknowns().points());
  q_.resize(all);
  v_.resize(all);
  f_.resize(all);
}

bool FirstOrderForm::forces(double time, ConstVectorRef y, VectorRef f) {
  const auto n = system_.unknowns().size();
  ++evaluations_;
  system_.expand(time, y.head(n), y.tail(n), q_, v_);
  system_.force({time, q_, v_}, f_);
  system_.unknowns().gather(f_, f);
  system_.unknowns().clear_held(f);
  return f.allFinite();
}

bool FirstOrderForm::rates(double time, ConstVectorRef y, VectorRef y_dot) {
  const auto n = system_.unknowns().size();
  auto acceleration = y_dot.tail(n);
  if (!forces(time, y, acceleration)) return false;
  for (int r = 0; r < system_.unknowns().rows(); ++r) {
    const double mass = system_.row_mass()[r];
    acceleration.segment<3>(3 * r) *= mass > 0 ? 1 / mass : 0.0;
  }
  y_dot.head(n) = y.tail(n);
  return true;
}

void FirstOrderForm::events(double time, ConstVectorRef y, const EventSource& source, std::span<double> values) {
  const auto n = system_.unknowns().size();
  system_.expand(time, y.head(n), y.tail(n), q_, v_);
  source.evaluate({time, q_, v_}, values);
}

}  // namespace sundrape

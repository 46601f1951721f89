#include "sundrape/force/dead_load.hpp"

namespace sundrape {

DeadLoad::DeadLoad(std::string name, EnergyKind kind, Vector forces, Ramp ramp)
    : name_(std::move(name)), kind_(kind), forces_(std::move(forces)), ramp_(ramp) {}

double DeadLoad::external_power(const State& state) const {
  const double share = ramp_.at(state.time);
  return share == 1 ? 0.0 : (share - 1) * forces_.dot(state.v);
}

Vector weight(const Vector& mass, const Vector3& acceleration) {
  Vector forces(3 * mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) forces.segment<3>(3 * i) = mass[i] * acceleration;
  return forces;
}

}  // namespace sundrape

#include "sundrape/force/dead_load.hpp"

namespace sundrape {

DeadLoad::DeadLoad(std::string name, EnergyKind kind, Vector forces, LoadCourse course)
    : name_(std::move(name)), kind_(kind), forces_(std::move(forces)), course_(std::move(course)) {}

double DeadLoad::external_power(const State& state) const {
  const double held_back = course_.share(state) - course_.share_of_potential(state);
  return held_back == 0 ? 0.0 : held_back * forces_.dot(state.v);
}

Vector weight(const Vector& mass, const Vector3& acceleration) {
  Vector forces(3 * mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) forces.segment<3>(3 * i) = mass[i] * acceleration;
  return forces;
}

}  // namespace sundrape

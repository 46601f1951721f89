#pragma once
#include "sundrape/force/dead_load.hpp"
#include "sundrape/force/stretch_springs.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape::samples {

constexpr double hanging_mass = 0.02, spring_stiffness = 5, spring_length = 0.1;  // [kg], [N/m], [m]

/// All points, the mass `stretch` [m] lower than where the spring is as long as at rest.
inline Vector below(double stretch = 0) {
  Vector start = Vector::Zero(6);
  start[5] = -spring_length - stretch;
  return start;
}

/// A mass (point 1) below a held point (0) on a spring; gravity [m/s²] downwards, relaxation time of the damping [s].
inline System mass_on_spring(double gravity, double relaxation_time = 0) {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(std::make_unique<StretchSprings>(std::vector<StretchSpring>{{0, 1, spring_length, spring_stiffness}},
                                                   EnergyKind::membrane, relaxation_time));
  const Vector mass = Vector::Constant(2, hanging_mass);
  if (gravity > 0)
    terms.push_back(std::make_unique<DeadLoad>("gravity", EnergyKind::gravity, weight(mass, Vector3(0, 0, -gravity))));
  return {mass, std::move(terms), Unknowns({{true, true, true}, {false, false, false}}), below()};
}

}  // namespace sundrape::samples

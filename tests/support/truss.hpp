#pragma once
#include <cmath>

#include "sundrape/force/dead_load.hpp"
#include "sundrape/force/stretch_springs.hpp"
#include "sundrape/system/system.hpp"

namespace sundrape::samples {

/// Von Mises' truss: two bars between hinges at (±a, 0, 0) and a joint at (0, 0, h) that moves up and down only,
/// pressed down by a force. With l = √(a² + z²) and l₀ its value at rest,
///     P(z) = 2 k (l₀ − l) z/l,    with its extremes where l³ = l₀ a²,
/// which follows from dP/dz = 0.
struct Truss {
  double half_span = 0.1, rise = 0.02, stiffness = 50;  // [m], [m], [N/m]
  double full_load = 0.2;                               // downwards [N]

  [[nodiscard]] double rest_length() const { return std::hypot(half_span, rise); }
  [[nodiscard]] double load(double z) const {
    const double l = std::hypot(half_span, z);
    return 2 * stiffness * (rest_length() - l) * z / l;
  }
  [[nodiscard]] double limit_height() const {
    const double l = std::cbrt(rest_length() * half_span * half_span);
    return std::sqrt(l * l - half_span * half_span);
  }
  [[nodiscard]] Vector start() const {
    Vector q = Vector::Zero(9);
    q[0] = -half_span;
    q[3] = half_span;
    q[8] = rise;
    return q;
  }
  [[nodiscard]] System system(std::vector<double> stages = {1}) const {
    std::vector<std::unique_ptr<ForceTerm>> terms;
    terms.push_back(std::make_unique<StretchSprings>(
        std::vector<StretchSpring>{{0, 2, rest_length(), stiffness}, {1, 2, rest_length(), stiffness}},
        EnergyKind::membrane));
    Vector force = Vector::Zero(9);
    force[8] = -full_load;
    terms.push_back(
        std::make_unique<DeadLoad>("force", EnergyKind::load, force, LoadCourse{.stages = std::move(stages)}));
    return {Vector::Ones(3), std::move(terms), Unknowns({{true, true, true}, {true, true, true}, {true, true, false}}),
            start()};
  }
};

}  // namespace sundrape::samples

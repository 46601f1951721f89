// A free sheet keeps its momenta while its springs vibrate and their strain-rate damping takes energy.
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/benchmarks.hpp"

namespace sundrape {
namespace {

/// The hanging cloth let go by its hands, 6 × 6 cells, damped by strain rate alone; integrated so tightly that what is
/// left of its momenta's drift is the forces' and the linear solver's.
Benchmark free_sheet(bool gravity, int cells) {
  auto b = benchmark("hanging_cloth.toml", {fmt::format("cloth.cells=[{0},{0}]", cells), "dynamics.rtol=1e-12",
                                            "dynamics.atol_position=1e-14", "dynamics.atol_velocity=1e-12",
                                            "dynamics.max_order=5", "dynamics.duration=0.1 s", "output.frames=10",
                                            "material.damping={ mass = 0, membrane = 1e-3, bending = 0.3e-3 }"});
  b.c.fixes.clear();
  if (!gravity) b.c.loads.clear();
  b.model = build_model(b.c);
  return b;
}

Vector3 linear_momentum(const System& system, const Vector& v) {
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < system.mass().size(); ++i) sum += system.mass()[i] * point(v, i);
  return sum;
}

Vector3 angular_momentum(const System& system, const Vector& q, const Vector& v) {
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < system.mass().size(); ++i)
    sum += system.mass()[i] * Vector3(point(q, i)).cross(Vector3(point(v, i)));
  return sum;
}

/// Rotation and translation of the sheet, and a vibration that stretches, shears and bends it.
Vector spin(const Vector& q, const Vector3& rate, const Vector3& drift) {
  Vector v(q.size());
  for (int i = 0; i < q.size() / 3; ++i) {
    const Vector3 x = point(q, i);
    point(v, i) = rate.cross(x) + drift +
                  0.5 * Vector3(std::sin(20 * x.x()), std::sin(15 * x.x() * x.y() / 0.1), std::cos(25 * x.y()));
  }
  return v;
}

struct Deviation {
  double linear, angular;  // largest over the frames, relative
  double damped;           // energy lost over the initial kinetic energy
};

Deviation free_motion(bool gravity, int cells) {
  const auto b = free_sheet(gravity, cells);
  const auto& system = *b.model.system;
  const Vector v = spin(b.model.initial, {3, -2, 8}, {0.3, 0.1, -0.2});
  const auto integrator = integrator_of(b);
  const auto m = motion(system, *integrator, b.c.output.frame_times, b.model.initial, v);
  const Vector3 g(0, 0, gravity ? -9.80665 : 0);
  const double mass = system.mass().sum();
  const Vector3 p0 = linear_momentum(system, v), h0 = angular_momentum(system, b.model.initial, v);
  Vector3 first_moment = Vector3::Zero();  // Σ m x at the start
  for (int i = 0; i < system.mass().size(); ++i) first_moment += system.mass()[i] * point(b.model.initial, i);
  Deviation d{0, 0, (m.energy.front() - m.energy.back()) / m.kinetic.front()};
  for (std::size_t f = 0; f < m.time.size(); ++f) {
    const double t = m.time[f];
    // P = P₀ + m g t,  dH/dt = (Σ m x) × g  with  Σ m x = S₀ + P₀ t + ½ m g t²
    const Vector3 p = p0 + mass * g * t, h = h0 + (first_moment * t + 0.5 * p0 * t * t).cross(g);
    d.linear = std::max(d.linear, (linear_momentum(system, m.velocity[f]) - p).norm() / p0.norm());
    d.angular = std::max(d.angular, (angular_momentum(system, m.position[f], m.velocity[f]) - h).norm() / h0.norm());
  }
  fmt::print("{} cells{}: linear {:.1e}, angular {:.1e}, {:.1f} % of the kinetic energy damped; {} steps\n", cells,
             gravity ? " in free fall" : "", d.linear, d.angular, 100 * d.damped, m.statistics.steps);
  return d;
}

void expect_kept(bool gravity, int cells) {
  const auto d = free_motion(gravity, cells);
  EXPECT_LT(d.linear, 1e-10);
  EXPECT_LT(d.angular, 1e-10);
  EXPECT_GT(d.damped, 0.01);  // the damping was at work
}

TEST(Momentum, IsKeptInFreeRotation) { expect_kept(false, 3); }
TEST(Momentum, GrowsByTheWeightAloneInFreeFall) { expect_kept(true, 3); }

TEST(MomentumVerification, IsKeptOnAFinerNet) {
  expect_kept(false, 8);
  expect_kept(true, 8);
}

}  // namespace
}  // namespace sundrape

#include "support/force_term_checks.hpp"

#include <numeric>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sundrape {
namespace {

Vector force(const ForceTerm& term, const State& state) {
  Vector f = Vector::Zero(state.q.size());
  term.add_force(state, f);
  return f;
}

double uniform(std::mt19937& random) { return std::uniform_real_distribution<>(-1, 1)(random); }

}  // namespace

TestState random_state(int points, unsigned seed, double scale) {
  std::vector<Vector3> nodes;
  nodes.reserve(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    const int column = i % 3, row = i / 3;
    nodes.emplace_back(scale * column, scale * row, 0.3 * scale * ((i * i) % 4));
  }
  return perturbed(nodes, 0.3 * scale, 10 * scale, seed);
}

TestState perturbed(const std::vector<Vector3>& nodes, double amplitude, double speed, unsigned seed) {
  std::mt19937 random(seed);
  TestState s;
  const auto n = static_cast<Eigen::Index>(3 * nodes.size());
  s.q.resize(n);
  s.v.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    s.q[k] = nodes[static_cast<std::size_t>(k / 3)][k % 3] + amplitude * uniform(random);
    s.v[k] = speed * uniform(random);
  }
  return s;
}

Eigen::MatrixXd dense_tangent(const ForceTerm& term, const State& state, double dq, double dv, Symmetry symmetry) {
  std::vector<int> all(static_cast<std::size_t>(state.q.size() / 3));
  std::iota(all.begin(), all.end(), 0);
  (void)term.adapt(state);
  Pattern pattern(all);
  term.declare_pattern(pattern);
  const auto built = pattern.build();
  BlockMatrix matrix(built.structure, symmetry);
  matrix.set_zero();
  Assembler assembler(matrix, built.tables.at(0));
  term.add_tangent(state, dq, dv, assembler);
  return matrix.dense();
}

void expect_force_is_energy_gradient(const ForceTerm& term, const TestState& state, double relative) {
  TestState still = state;
  still.v.setZero();  // the energy knows no rates
  const Vector f = force(term, still);
  const double scale = std::max(f.cwiseAbs().maxCoeff(), 1e-300);
  const double step = 1e-5 * (state.q.maxCoeff() - state.q.minCoeff());
  for (Eigen::Index k = 0; k < state.q.size(); ++k) {
    auto sample = [&](double d) {
      TestState s = still;
      s.q[k] += d;
      return term.energy(s);
    };
    // fourth-order central difference
    const double slope = (8 * (sample(step) - sample(-step)) - (sample(2 * step) - sample(-2 * step))) / (12 * step);
    EXPECT_NEAR(f[k], -slope, relative * scale) << term.name() << ", component " << k;
  }
}

void expect_tangent_is_force_derivative(const ForceTerm& term, const TestState& state, double relative) {
  for (const auto& [dq, dv] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{0.7, 0.02}}) {
    const Eigen::MatrixXd exact = dense_tangent(term, state, dq, dv, Symmetry::unsymmetric);
    const double scale = exact.cwiseAbs().maxCoeff();
    const double step_q = 1e-5 * (state.q.maxCoeff() - state.q.minCoeff()),
                 step_v = 1e-5 * std::max(1e-3, state.v.cwiseAbs().maxCoeff());
    for (Eigen::Index k = 0; k < state.q.size(); ++k) {
      auto sample = [&](double step, bool rates) {
        TestState s = state;
        (rates ? s.v : s.q)[k] += step;
        return force(term, s);
      };
      auto slope = [&](double step, bool rates) -> Vector {
        return (8 * (sample(step, rates) - sample(-step, rates)) -
                (sample(2 * step, rates) - sample(-2 * step, rates))) /
               (12 * step);
      };
      Vector column = Vector::Zero(state.q.size());
      if (dq != 0) column += dq * slope(step_q, false);
      if (dv != 0) column += dv * slope(step_v, true);
      EXPECT_LE((exact.col(k) - column).cwiseAbs().maxCoeff(), relative * std::max(scale, 1e-300))
          << term.name() << ", column " << k << ", dq " << dq << ", dv " << dv;
    }
  }
}

void expect_symmetric_tangent_is_symmetric_part(const ForceTerm& term, const TestState& state, double relative) {
  TestState still = state;
  still.v.setZero();
  for (const auto& [dq, dv] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{0.7, 0.02}}) {
    const Eigen::MatrixXd whole = dense_tangent(term, still, dq, dv, Symmetry::unsymmetric);
    const Eigen::MatrixXd kept = dense_tangent(term, still, dq, dv, Symmetry::symmetric);
    const double scale = whole.cwiseAbs().maxCoeff();
    EXPECT_LE((kept - 0.5 * (whole + whole.transpose())).cwiseAbs().maxCoeff(), relative * scale)
        << term.name() << ", dq " << dq << ", dv " << dv;
  }
}

void expect_consistent(const ForceTerm& term, const TestState& state, double relative) {
  if (term.kind() != EnergyKind::none) expect_force_is_energy_gradient(term, state, relative);
  expect_tangent_is_force_derivative(term, state, relative);
  expect_symmetric_tangent_is_symmetric_part(term, state);
}

void expect_dissipates_what_it_says(const ForceTerm& term, const TestState& state, double relative) {
  TestState still = state;
  still.v.setZero();
  const Vector damping = force(term, state) - force(term, still);
  const double power = term.dissipated_power(state);
  EXPECT_GE(power, 0);
  EXPECT_NEAR(-damping.dot(state.v), power, relative * std::max(power, 1e-300)) << term.name();
}

void expect_no_force_under_rigid_motion(const ForceTerm& term, const std::vector<Vector3>& rest, double force_scale) {
  for (const double angle : {0.0, 1.0, 2.9}) {
    const Matrix3 turn = Eigen::AngleAxisd(angle, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    const Vector3 shift(0.3, -0.1, 0.2), spin(3, 1, -2), speed(0.5, 0.1, -1);
    TestState s;
    s.q.resize(static_cast<Eigen::Index>(3 * rest.size()));
    s.v.resize(s.q.size());
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(3 * i);
      s.q.segment<3>(at) = turn * rest[i] + shift;
      s.v.segment<3>(at) = speed + spin.cross(Vector3(s.q.segment<3>(at)));
    }
    EXPECT_LE(force(term, s).cwiseAbs().maxCoeff(), 1e-10 * force_scale) << term.name() << " turned by " << angle;
    EXPECT_LE(term.dissipated_power(s), 1e-18 * force_scale) << term.name();
  }
}

void expect_self_equilibrated(const ForceTerm& term, const TestState& state, double relative) {
  const Vector f = force(term, state);
  Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
  for (Eigen::Index k = 0; k < f.size(); k += 3) {
    sum += f.segment<3>(k);
    moment += Vector3(state.q.segment<3>(k)).cross(Vector3(f.segment<3>(k)));
  }
  EXPECT_LE(sum.norm(), relative * f.norm()) << term.name();
  EXPECT_LE(moment.norm(), relative * f.norm() * state.q.cwiseAbs().maxCoeff()) << term.name();
}

}  // namespace sundrape

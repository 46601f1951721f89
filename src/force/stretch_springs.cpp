#include "sundrape/force/stretch_springs.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace sundrape {
namespace {

/// What a spring is doing in a given state.
struct Stretched {
  Vector3 direction;  // unit vector from i to j
  Vector3 velocity;   // v_j − v_i [m/s]
  double length;      // current length [m]
  double rate;        // its rate [m/s]
  double stiffness;   // D' k [N/m]
  double viscosity;   // β k [N s/m]
  double tension;     // D' k Δb + β k d(length)/dt [N]
};

Stretched stretched(const StretchSpring& s, const State& state, double relaxation_time, double compression_factor) {
  Stretched r;
  const Vector3 chord = point(state.q, s.j) - point(state.q, s.i);
  r.velocity = point(state.v, s.j) - point(state.v, s.i);
  r.length = chord.norm();
  r.direction = chord / r.length;
  r.rate = r.direction.dot(r.velocity);
  r.stiffness = r.length < s.length ? compression_factor * s.stiffness : s.stiffness;
  r.viscosity = relaxation_time * s.stiffness;
  r.tension = r.stiffness * (r.length - s.length) + r.viscosity * r.rate;
  return r;
}

}  // namespace

StretchSprings::StretchSprings(std::vector<StretchSpring> springs, EnergyKind kind, double relaxation_time,
                               double compression_factor)
    : springs_(std::move(springs)),
      kind_(kind),
      relaxation_time_(relaxation_time),
      compression_factor_(compression_factor) {
  if (!(relaxation_time >= 0))
    throw std::invalid_argument("the relaxation time of stretching must not be negative [s]");
  if (!(compression_factor >= 0 && compression_factor <= 1))
    throw std::invalid_argument("the compression factor D' must lie in [0, 1]");
  for (const auto& s : springs_) {
    if (!(s.length > 0)) throw std::invalid_argument("a stretch spring has no length: two nodes coincide at rest");
    if (!(s.stiffness > 0)) throw std::invalid_argument("a stretch spring has no stiffness");
  }
  const auto reach = [](const StretchSpring& s) { return std::minmax({s.i, s.j}); };
  std::ranges::sort(springs_, {}, [&](const StretchSpring& s) { return std::pair<int, int>(reach(s)); });
  std::vector<std::pair<int, int>> reaches;
  reaches.reserve(springs_.size());
  for (const auto& s : springs_) reaches.emplace_back(reach(s));
  stripes_ = Stripes(reaches);
}

double StretchSprings::energy(const State& state) const {
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (auto e = begin; e < end; ++e) {
      const auto s = stretched(springs_[e], state, 0, compression_factor_);
      sum += 0.5 * s.tension * (s.length - springs_[e].length);
    }
    return sum;
  });
}

double StretchSprings::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (auto e = begin; e < end; ++e) {
      const auto s = stretched(springs_[e], state, relaxation_time_, compression_factor_);
      sum += s.viscosity * s.rate * s.rate;
    }
    return sum;
  });
}

void StretchSprings::add_force(const State& state, VectorRef f) const {
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; ++e) {
      const auto s = stretched(springs_[e], state, relaxation_time_, compression_factor_);
      const Vector3 pull = s.tension * s.direction;
      point(f, springs_[e].i) += pull;
      point(f, springs_[e].j) -= pull;
    }
  });
}

void StretchSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; ++e) {
      const auto s = stretched(springs_[e], state, relaxation_time_, compression_factor_);
      const Matrix3 along = s.direction * s.direction.transpose();
      const Matrix3 across = Matrix3::Identity() - along;
      // ∂f_j/∂x_j: along the thread the spring's stiffness, across it the tension over the length.
      const Matrix3 block = -(dq * s.stiffness + dv * s.viscosity) * along - (dq * s.tension / s.length) * across;
      if (!exact) {
        tangent.add_diagonal(e, 0, block);
        tangent.add_diagonal(e, 1, block);
        tangent.add_pair(e, 0, 1, -block);
        continue;
      }
      // the spring's rate changes as it turns: −β k u ⊗ (I − u⊗u)(v_j − v_i)/length
      const Matrix3 full = block - (dq * s.viscosity / s.length) * s.direction * (across * s.velocity).transpose();
      tangent.add_diagonal(e, 0, full);
      tangent.add_diagonal(e, 1, full);
      tangent.add_general_pair(e, 0, 1, -full, -full);
    }
  });
}

void StretchSprings::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(2);
  for (const auto& s : springs_) pattern.add_element(std::array{s.i, s.j});
}

std::pair<double, double> StretchSprings::strain_range(ConstVectorRef q) const {
  if (springs_.empty()) return {0, 0};
  auto smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
  for (const auto& s : springs_) {
    const double strain = (point(q, s.j) - point(q, s.i)).norm() / s.length - 1;
    smallest = std::min(smallest, strain);
    largest = std::max(largest, strain);
  }
  return {smallest, largest};
}

}  // namespace sundrape

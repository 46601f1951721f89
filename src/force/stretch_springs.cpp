#include "sundrape/force/stretch_springs.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "batch.hpp"

namespace sundrape {
namespace {

ElementTable<2, 2> table(std::span<const StretchSpring> springs) {
  std::vector<ElementTable<2, 2>::Element> rows;
  rows.reserve(springs.size());
  for (const auto& s : springs) rows.push_back({{s.i, s.j}, {s.length, s.stiffness}});
  return ElementTable<2, 2>(rows);
}

}  // namespace

/// What consecutive springs are doing in a given state.
struct StretchSprings::Stretched {
  Batch3 direction;  // unit vector from i to j
  Batch3 velocity;   // v_j − v_i [m/s]
  Batch length;      // current length [m]
  Batch elongation;  // Δb [m]
  Batch rate;        // its rate [m/s]
  Batch stiffness;   // D' k [N/m]
  Batch viscosity;   // β k [N s/m]
  Batch tension;     // D' k Δb + β k d(length)/dt [N]

  /// [J], of springs seen without their damping
  [[nodiscard]] Batch energy() const { return Batch(0.5) * tension * elongation; }
};

StretchSprings::Stretched StretchSprings::stretched(std::size_t first, const State& state,
                                                    double relaxation_time) const {
  const auto difference = [&](const ConstVectorRef& x) -> Batch3 {
    return gather(x, table_, 1, first) - gather(x, table_, 0, first);
  };
  const Batch rest = load(table_, Number::length, first);
  const Batch modulus = load(table_, Number::stiffness, first);
  const Batch3 chord = difference(state.q);
  Stretched s;
  s.velocity = difference(state.v);
  s.length = xsimd::sqrt(chord.squaredNorm());
  s.direction = (Batch(1.0) / s.length) * chord;
  s.elongation = s.length - rest;
  s.rate = s.direction.dot(s.velocity);
  s.stiffness = xsimd::select(s.elongation < Batch(0.0), Batch(compression_factor_) * modulus, modulus);
  s.viscosity = Batch(relaxation_time) * modulus;
  s.tension = s.stiffness * s.elongation + s.viscosity * s.rate;
  return s;
}

StretchSprings::StretchSprings(const std::vector<StretchSpring>& springs, EnergyKind kind, double relaxation_time,
                               double compression_factor)
    : kind_(kind), relaxation_time_(relaxation_time), compression_factor_(compression_factor) {
  if (!(relaxation_time >= 0))
    throw std::invalid_argument("the relaxation time of stretching must not be negative [s]");
  if (!(compression_factor >= 0 && compression_factor <= 1))
    throw std::invalid_argument("the compression factor D' must lie in [0, 1]");
  for (const auto& s : springs) {
    if (!(s.length > 0)) throw std::invalid_argument("a stretch spring has no length: two nodes coincide at rest");
    if (!(s.stiffness > 0)) throw std::invalid_argument("a stretch spring has no stiffness");
  }
  auto sorted = springs;
  stripes_ = sort_into_stripes(sorted, [](const StretchSpring& s) { return std::array{s.i, s.j}; });
  table_ = table(sorted);
}

double StretchSprings::energy(const State& state) const {
  return sum_over_batches(stripes_, [&](std::size_t e) -> Batch { return stretched(e, state, 0).energy(); });
}

void StretchSprings::add_strain_energy(const State& state, VectorRef of_points) const {
  share_among_points(
      stripes_, table_, 0, 1, [&](std::size_t e) -> Batch { return stretched(e, state, 0).energy(); }, of_points);
}

double StretchSprings::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  return sum_over_batches(stripes_, [&](std::size_t e) -> Batch {
    const auto s = stretched(e, state, relaxation_time_);
    return s.viscosity * s.rate * s.rate;
  });
}

void StretchSprings::add_force(const State& state, VectorRef f) const {
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    LaneBuffer<6> pull;
    const auto s = stretched(e, state, relaxation_time_);
    pull.store(0, s.tension * s.direction);
    pull.store(3, -s.tension * s.direction);
    scatter_add(pull, table_, e, count, f);
  });
}

void StretchSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    LaneMatrices<2> blocks;
    const auto s = stretched(e, state, relaxation_time_);
    // −∂f_j/∂x_j: along the thread the spring's stiffness, across it the tension over the length
    const Batch across = Batch(dq) * s.tension / s.length;
    const Batch3 along = (Batch(dq) * s.stiffness + Batch(dv) * s.viscosity - across) * s.direction;
    Batch3x3 block = along * s.direction.transpose();
    block.diagonal().array() += across;
    if (exact) {  // the spring's rate changes as it turns: β k u ⊗ (I − u⊗u)(v_j − v_i)/length
      const Batch3 turning = (Batch(dq) * s.viscosity / s.length) * (s.velocity - s.rate * s.direction);
      block += s.direction * turning.transpose();
    }
    blocks.store(0, block);
    blocks.store(1, -block);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const Matrix3 &pair = blocks(0, lane), &own = blocks(1, lane);
      tangent.add_diagonal(e + lane, 0, own);
      tangent.add_diagonal(e + lane, 1, own);
      if (exact)
        tangent.add_general_pair(e + lane, 0, 1, pair, pair);
      else
        tangent.add_pair_below(e + lane, 0, 1, pair);
    }
  });
}

void StretchSprings::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(2);
  for (std::size_t e = 0; e < table_.size(); ++e) pattern.add_element(table_.points_of(e));
}

}  // namespace sundrape

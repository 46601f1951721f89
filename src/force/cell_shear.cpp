#include "sundrape/force/cell_shear.hpp"

#include <algorithm>
#include <stdexcept>

#include "batch.hpp"

namespace sundrape {
namespace {

/// −∂²/∂x_p∂x_q of cells from the second derivatives by their diagonals. Node k of a cell is an end of diagonal k mod
/// 2, the far end for k ≥ 2.
class CellBlocks {
 public:
  /// d11, d12, d21, d22: by D₁, D₂, rows by the first
  CellBlocks(const Batch3x3& d11, const Batch3x3& d12, const Batch3x3& d21, const Batch3x3& d22) {
    store(b11, d11);
    store(b12, d12);
    store(b21, d21);
    store(b22, d22);
    store(minus_11, -d11);
    store(minus_12, -d12);
    store(minus_21, -d21);
    store(minus_22, -d22);
  }

  void add(std::size_t lane, std::size_t e, Assembler& tangent) const {
    const auto block = [&](Kind kind) -> const Matrix3& { return blocks_(kind, lane); };
    tangent.add_diagonal(e, 0, block(minus_11));
    tangent.add_diagonal(e, 1, block(minus_22));
    tangent.add_diagonal(e, 2, block(minus_11));
    tangent.add_diagonal(e, 3, block(minus_22));
    if (tangent.keeps_unsymmetric()) {
      tangent.add_general_pair(e, 0, 1, block(minus_12), block(minus_21));
      tangent.add_general_pair(e, 0, 2, block(b11), block(b11));
      tangent.add_general_pair(e, 0, 3, block(b12), block(b21));
      tangent.add_general_pair(e, 1, 2, block(b21), block(b12));
      tangent.add_general_pair(e, 1, 3, block(b22), block(b22));
      tangent.add_general_pair(e, 2, 3, block(minus_12), block(minus_21));
      return;
    }
    tangent.add_pair_below(e, 0, 1, block(minus_21));
    tangent.add_pair_below(e, 0, 2, block(b11));
    tangent.add_pair_below(e, 0, 3, block(b21));
    tangent.add_pair_below(e, 1, 2, block(b12));
    tangent.add_pair_below(e, 1, 3, block(b22));
    tangent.add_pair_below(e, 2, 3, block(minus_21));
  }

 private:
  enum Kind : std::size_t { b11, b12, b21, b22, minus_11, minus_12, minus_21, minus_22, kinds };
  void store(Kind kind, const Batch3x3& block) { blocks_.store(kind, block); }

  LaneMatrices<kinds> blocks_;
};

ElementTable<4, 3> table(std::span<const ShearCell> cells) {
  std::vector<ElementTable<4, 3>::Element> rows;
  rows.reserve(cells.size());
  for (const auto& c : cells) rows.push_back({c.nodes, {0.5 / c.scale, c.rest, c.stiffness}});
  return ElementTable<4, 3>(rows);
}

}  // namespace

struct CellShear::Sheared {
  Batch3 g1, g2;         // ∂γ/∂D₁, ∂γ/∂D₂ [1/m]
  Batch3 h1, h2;         // rates of g1 and g2 [1/(m s)]
  Batch strain;          // γ
  Batch rate;            // dγ/dt [1/s]
  Batch half_per_scale;  // 1/(2 |p₀||q₀|) [1/m²]
  Batch stiffness;       // [J]

  [[nodiscard]] Batch energy() const { return Batch(0.5) * stiffness * strain * strain; }
};

CellShear::Sheared CellShear::sheared(std::size_t first, const State& state) const {
  const auto diagonal = [&](const ConstVectorRef& x, std::size_t from) -> Batch3 {
    return gather(x, table_, from + 2, first) - gather(x, table_, from, first);
  };
  const Batch3 d1 = diagonal(state.q, 0), d2 = diagonal(state.q, 1);
  Sheared s;
  s.stiffness = load(table_, stiffness, first);
  s.half_per_scale = load(table_, half_per_scale, first);
  s.g1 = s.half_per_scale * d1;
  s.g2 = -s.half_per_scale * d2;
  s.h1 = s.half_per_scale * diagonal(state.v, 0);
  s.h2 = -s.half_per_scale * diagonal(state.v, 1);
  s.strain = Batch(0.5) * s.half_per_scale * (d1.squaredNorm() - d2.squaredNorm() - load(table_, rest, first));
  s.rate = s.h1.dot(d1) + s.h2.dot(d2);
  return s;
}

CellShear::CellShear(const std::vector<ShearCell>& cells, double relaxation_time) : relaxation_time_(relaxation_time) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of shear must not be negative [s]");
  for (const auto& c : cells)
    if (!(c.scale > 0 && c.stiffness > 0)) throw std::invalid_argument("a cell has no area or no shear stiffness");
  auto sorted = cells;
  stripes_ = sort_into_stripes(sorted, [](const ShearCell& c) { return c.nodes; });
  table_ = table(sorted);
}

double CellShear::energy(const State& state) const {
  return sum_over_batches(stripes_, [&](std::size_t e) -> Batch { return sheared(e, state).energy(); });
}

void CellShear::add_strain_energy(const State& state, VectorRef of_points) const {
  share_among_points(
      stripes_, table_, 0, 3, [&](std::size_t e) -> Batch { return sheared(e, state).energy(); }, of_points);
}

double CellShear::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  return sum_over_batches(stripes_, [&](std::size_t e) -> Batch {
    const auto s = sheared(e, state);
    return Batch(relaxation_time_) * s.stiffness * s.rate * s.rate;
  });
}

void CellShear::add_force(const State& state, VectorRef f) const {
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    LaneBuffer<12> pull;
    const auto s = sheared(e, state);
    const Batch stress = s.stiffness * (s.strain + Batch(relaxation_time_) * s.rate);
    pull.store(0, stress * s.g1);
    pull.store(3, stress * s.g2);
    pull.store(6, -stress * s.g1);
    pull.store(9, -stress * s.g2);
    scatter_add(pull, table_, e, count, f);
  });
}

void CellShear::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    const auto s = sheared(e, state);
    const Batch viscosity = Batch(relaxation_time_) * s.stiffness;
    const Batch modulus = Batch(dq) * s.stiffness + Batch(dv) * viscosity;
    const Batch geometric = Batch(dq) * (s.stiffness * s.strain + viscosity * s.rate) * s.half_per_scale;
    // material part g gᵀ, geometric part ±σ I; the rate's own change g hᵀ
    const Batch3 m1 = modulus * s.g1, m2 = modulus * s.g2;
    Batch3x3 d11 = m1 * s.g1.transpose(), d12 = m1 * s.g2.transpose(), d22 = m2 * s.g2.transpose();
    Batch3x3 d21 = d12.transpose();
    d11.diagonal().array() += geometric;
    d22.diagonal().array() -= geometric;
    if (exact) {
      const Batch3 h1 = Batch(dq) * viscosity * s.h1, h2 = Batch(dq) * viscosity * s.h2;
      d11 += s.g1 * h1.transpose();
      d12 += s.g1 * h2.transpose();
      d21 += s.g2 * h1.transpose();
      d22 += s.g2 * h2.transpose();
    }
    const CellBlocks blocks(d11, d12, d21, d22);
    for (std::size_t lane = 0; lane < count; ++lane) blocks.add(lane, e + lane, tangent);
  });
}

void CellShear::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (std::size_t e = 0; e < table_.size(); ++e) pattern.add_element(table_.points_of(e));
}

}  // namespace sundrape

#include "sundrape/force/cell_shear.hpp"

#include <algorithm>
#include <stdexcept>

namespace sundrape {
namespace {

struct Sheared {
  Vector3 g1, g2;  // ∂γ/∂D₁, ∂γ/∂D₂ [1/m]
  Vector3 h1, h2;  // rates of g1 and g2 [1/(m s)]
  double strain;   // γ
  double rate;     // dγ/dt [1/s]
};

Sheared sheared(const ShearCell& cell, const State& state) {
  const auto& [n1, n2, n3, n4] = cell.nodes;
  const Vector3 d1 = point(state.q, n3) - point(state.q, n1), d2 = point(state.q, n4) - point(state.q, n2);
  const double per_scale = 0.5 / cell.scale;
  Sheared s;
  s.g1 = per_scale * d1;
  s.g2 = -per_scale * d2;
  s.h1 = per_scale * (point(state.v, n3) - point(state.v, n1));
  s.h2 = -per_scale * (point(state.v, n4) - point(state.v, n2));
  s.strain = 0.5 * per_scale * (d1.squaredNorm() - d2.squaredNorm() - cell.rest);
  s.rate = s.h1.dot(d1) + s.h2.dot(d2);
  return s;
}

/// Node k of a cell is an end of diagonal k mod 2, the far end for k ≥ 2.
constexpr double end_sign(int k) { return k < 2 ? -1.0 : 1.0; }

}  // namespace

CellShear::CellShear(std::vector<ShearCell> cells, double relaxation_time)
    : cells_(std::move(cells)), relaxation_time_(relaxation_time) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of shear must not be negative [s]");
  for (const auto& c : cells_)
    if (!(c.scale > 0 && c.stiffness > 0)) throw std::invalid_argument("a cell has no area or no shear stiffness");
  const auto reach = [](const ShearCell& c) {
    return std::pair<int, int>(*std::ranges::min_element(c.nodes), *std::ranges::max_element(c.nodes));
  };
  std::ranges::sort(cells_, {}, reach);
  std::vector<std::pair<int, int>> reaches;
  reaches.reserve(cells_.size());
  for (const auto& c : cells_) reaches.push_back(reach(c));
  stripes_ = Stripes(reaches);
}

double CellShear::energy(const State& state) const {
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (auto e = begin; e < end; ++e) {
      const double strain = sheared(cells_[e], state).strain;
      sum += 0.5 * cells_[e].stiffness * strain * strain;
    }
    return sum;
  });
}

double CellShear::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (auto e = begin; e < end; ++e) {
      const double rate = sheared(cells_[e], state).rate;
      sum += relaxation_time_ * cells_[e].stiffness * rate * rate;
    }
    return sum;
  });
}

void CellShear::add_force(const State& state, VectorRef f) const {
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; ++e) {
      const auto& cell = cells_[e];
      const auto s = sheared(cell, state);
      const double stress = cell.stiffness * (s.strain + relaxation_time_ * s.rate);
      const Vector3 f1 = stress * s.g1, f2 = stress * s.g2;
      point(f, cell.nodes[0]) += f1;
      point(f, cell.nodes[2]) -= f1;
      point(f, cell.nodes[1]) += f2;
      point(f, cell.nodes[3]) -= f2;
    }
  });
}

void CellShear::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; ++e) {
      const auto& cell = cells_[e];
      const auto s = sheared(cell, state);
      const double viscosity = relaxation_time_ * cell.stiffness;
      const double stress = cell.stiffness * s.strain + viscosity * s.rate;
      const double modulus = dq * cell.stiffness + dv * viscosity;
      const Matrix3 geometric = (dq * stress * 0.5 / cell.scale) * Matrix3::Identity();
      // ∂f/∂D of the two diagonals, negated: material part g gᵀ, geometric part ±σ I; the rate's own change g hᵀ.
      std::array<std::array<Matrix3, 2>, 2> block;
      const std::array<const Vector3*, 2> g{&s.g1, &s.g2}, h{&s.h1, &s.h2};
      for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b) {
          block[a][b] = modulus * *g[a] * g[b]->transpose();
          if (exact) block[a][b] += (dq * viscosity) * *g[a] * h[b]->transpose();
        }
      block[0][0] += geometric;
      block[1][1] -= geometric;
      for (int q = 0; q < 4; ++q) {
        const auto b = static_cast<std::size_t>(q % 2);
        tangent.add_diagonal(e, q, -block[b][b]);
        for (int p = 0; p < q; ++p) {
          const auto a = static_cast<std::size_t>(p % 2);
          const double sign = -end_sign(p) * end_sign(q);
          if (exact)
            tangent.add_general_pair(e, p, q, sign * block[a][b], sign * block[b][a]);
          else
            tangent.add_pair(e, p, q, sign * block[a][b]);
        }
      }
    }
  });
}

void CellShear::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(4);
  for (const auto& c : cells_) pattern.add_element(c.nodes);
}

}  // namespace sundrape
